// The data of the figures of the cut in docs/architecture.md, as JSON: each scene is the last step
// of some strokes that the real cutter makes through a small body. scripts/figures draws them.
#include <iostream>
#include <nlohmann/json.hpp>

#include "sim/cut/plan/plan.h"
#include "sim/cut/plan/strip/swept_strip.h"
#include "sim/cut/stroke/cutter.h"
#include "sim/cut/stroke/group_stroke.h"
#include "sim/cut/stroke/ladder.h"
#include "sim/mesh/triangle_tree.h"
#include "tests/support/cut_strokes.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

using Json = nlohmann::json;

constexpr double kWallEdge = 0.16;  // [m], coarse enough to see each triangle

struct Scene {
    SurfaceMesh body;
    std::vector<test::Stroke> strokes;  ///< the last pose of the last one makes the step
};

Json pointOf(const Vec3& p) {
    return {p.x(), p.y(), p.z()};
}

Json rungOf(const std::vector<RungNode>& rung) {
    Json nodes = Json::array();
    for (const RungNode& node : rung) {
        nodes.push_back(
            {{"at", pointOf(node.position)}, {"vertex", node.vertex}, {"attached", node.attached}});
    }
    return nodes;
}

Json meshOf(const SurfaceMesh& mesh) {
    Json points = Json::array();
    Json copies = Json::array();
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        points.push_back(pointOf(mesh.position(v)));
        if (mesh.firstCopy(v) == v && mesh.copyGroup(v) >= 0) {
            copies.push_back(mesh.copiesOfGroup(mesh.copyGroup(v)));
        }
    }
    Json triangles = Json::array();
    Json labels = Json::array();
    for (const int t : livingTriangles(mesh)) {
        triangles.push_back(mesh.triangle(t));
        labels.push_back(mesh.wallLabel(t));
    }
    return {{"points", points}, {"triangles", triangles}, {"labels", labels}, {"copies", copies}};
}

Json stripOf(const cut::Strip& strip) {
    Json nodes = Json::array();
    for (const cut::StripNode& node : strip.nodes) {
        nodes.push_back(pointOf(node.position));
    }
    return {{"points", nodes},
            {"triangles", strip.triangles},
            {"old", strip.oldCount},
            {"new", strip.newRung}};
}

/// The outline and the triangles of W+, by places in `points`; `layout`: those in the strip's
/// plane.
Json planOf(const SurfaceMesh& mesh, const cut::StepPlan& plan) {
    constexpr std::array kKinds{"cut", "free", "front"};
    Json points = Json::array();
    Json layout = Json::array();
    std::map<int, int> placeOfCorner;
    for (int i = 0; i < cut::sizeOf(plan.curves.nodes); ++i) {
        const auto& node = plan.curves.nodes[i];
        points.push_back(pointOf(node.position));
        layout.push_back({node.layout.x(), node.layout.y()});
        placeOfCorner[cut::cornerId(mesh, plan.curves, i)] = i;
    }
    Json outline = Json::array();
    for (const cut::OutlineEdge& edge : plan.outline.edges) {
        outline.push_back({edge.from, edge.to, kKinds[static_cast<std::size_t>(edge.kind)]});
    }
    Json wall = Json::array();
    for (const cut::NewTriangle& triangle : plan.triangles) {
        if (triangle.side == cut::CutSide::plus) {
            const auto& [a, b, c] = triangle.corners;
            wall.push_back({placeOfCorner.at(a), placeOfCorner.at(b), placeOfCorner.at(c)});
        }
    }
    return {{"points", points}, {"layout", layout}, {"outline", outline}, {"wallPlus", wall}};
}

/// The step from where the cutter stands to `to`, as it plans its first try. `firstVertex`: the
/// number of vertices when the stroke began.
Json stepOf(const SurfaceMesh& mesh, const Cutter& cutter, int stroke, int firstVertex,
            const Blade& to) {
    std::vector<RungNode> rung = cutter.rung();
    cut::followMesh(mesh, rung);
    cut::reparametrize(to, kWallEdge, rung);
    std::vector<Vec3> points{to.a, to.b};
    for (const RungNode& node : rung) {
        points.push_back(node.position);
    }
    TriangleTree tree(mesh);
    const cut::BroadPhase candidates(mesh, tree, to, points, 3 * kWallEdge, kWallEdge,
                                     [](int) { return true; });
    const std::vector<int> onePiece(mesh.vertexCount(), 0);
    const cut::EdgeLengthField edgeLengths(kWallEdge);
    const CutSettings settings;
    const cut::SlitOpening noOpening;
    std::map<int, Vec3> flushSides;
    const cut::StepInput in{.mesh = mesh,
                            .broadPhase = candidates,
                            .pieceOfVertex = onePiece,
                            .surface = cutter.strokeSurface(),
                            .opening = noOpening,
                            .rung = rung,
                            .blade = to,
                            .span = {},
                            .h = kWallEdge,
                            .offset = settings.offset,
                            .edgeLengths = edgeLengths,
                            .seed = settings.seed,
                            .stroke = stroke,
                            .transit = stroke + 1,
                            .firstVertexOfTransit = firstVertex,
                            .attempt = cut::attemptAt(cut::Level::asIs, settings.tolerance),
                            .flushSides = flushSides};
    cut::PredicatePositions positions(in);
    return {{"rung", rungOf(rung)},
            {"strip", stripOf(cut::buildStrip(in, positions))},
            {"plan", planOf(mesh, cut::planStep(in).plan)}};
}

Json sceneOf(Scene scene) {
    SurfaceMesh& mesh = scene.body;
    CutSettings settings;
    settings.wallEdgeLength = kWallEdge;
    Cutter cutter(mesh, settings);
    Json result;
    for (int stroke = 0; stroke < cut::sizeOf(scene.strokes); ++stroke) {
        const test::Stroke& poses = scene.strokes[stroke];
        const int firstVertex = mesh.vertexCount();
        cutter.begin(poses.front());
        for (std::size_t i = 1; i + 1 < poses.size(); ++i) {
            cutter.advance(poses[i]);
        }
        if (stroke + 1 == cut::sizeOf(scene.strokes)) {
            result["before"] = meshOf(mesh);
            result["step"] = stepOf(mesh, cutter, stroke, firstVertex, poses.back());
        }
        result["reason"] = cutter.advance(poses.back()).reason;  // empty: the first try succeeded
        result["rungAfter"] = rungOf(cutter.rung());
        if (stroke + 1 < cut::sizeOf(scene.strokes)) {
            cutter.finish();
        }
    }
    result["after"] = meshOf(mesh);
    return result;
}

Json ladder() {
    Json levels = Json::array();
    for (int i = 0; i < cut::kLevels; ++i) {
        const cut::Attempt level = cut::attemptAt(static_cast<cut::Level>(i), 0);
        levels.push_back({{"offset", level.offsetScale},
                          {"seenFlat", level.onSurface},
                          {"closed", level.closing == cut::kCloseDistance},
                          {"tolerance", level.tolerance}});
    }
    return levels;
}

/// A blade that goes down through `heights`, turned about +y by `angle` and moved aside to
/// `middle`.
test::Stroke strokeDown(const Vec3& middle, double angle, const std::vector<double>& heights) {
    const Vec3 half = 0.75 * Vec3(std::cos(angle), 0, std::sin(angle));
    test::Stroke stroke;
    for (const double y : heights) {
        const Vec3 at(middle.x(), y, middle.z());
        stroke.push_back({at - half, at + half});
    }
    return stroke;
}

}  // namespace
}  // namespace kerf

int main() {
    using namespace kerf;
    const auto ball = [] { return test::icosphere(2); };
    const test::Stroke across = strokeDown({0, 0, 0}, 0.1, {0.66, 0.5, 0.38, 0.26, 0.14, -0.15});
    const test::Stroke older =
        strokeDown({0, 0, 0}, 0.1, {0.66, 0.5, 0.34, 0.18, 0.02, -0.12, -0.24});
    const test::Stroke newer = strokeDown({0.03, 0, 0}, 1.6, {0.66, 0.5, 0.38, 0.26, -0.02});
    std::cout << Json{{"step", sceneOf({ball(), {across}})},
                      {"crossing", sceneOf({ball(), {older, newer}})},
                      {"ladder", ladder()}}
                     .dump()
              << '\n';
}

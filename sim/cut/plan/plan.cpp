#include "sim/cut/plan/plan.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "sim/base/pausing.h"
#include "sim/cut/plan/flush.h"
#include "sim/cut/plan/seams.h"
#include "sim/cut/plan/seeds.h"
#include "sim/cut/plan/skin_map.h"
#include "sim/cut/plan/wall.h"
#include "sim/mesh/triangle.h"

namespace kerf::cut {

namespace {

constexpr double kRoomAtFrontEnd = 0.3;  // share of the edge length at the end

RungNode airNode(const Strip& strip, int node, double s) {
    return {strip.nodes[node].position, s, -1, false};
}

// W+ turns the triangles of the layout plane over, W- keeps them.
void addWalls(const StepInput& in, const std::vector<WallSheet>& sheets, StepPlan& plan) {
    std::size_t count = plan.triangles.size();
    for (const WallSheet& sheet : sheets) {
        count += 2 * sheet.triangles.size();
    }
    plan.triangles.reserve(count);
    for (const CutSide side : {CutSide::plus, CutSide::minus}) {
        const int label = 2 * in.stroke + (side == CutSide::plus ? 0 : 1);
        for (const WallSheet& sheet : sheets) {
            for (const Triangle& t : sheet.triangles) {
                Triangle c{};
                for (int i = 0; i < 3; ++i) {
                    c[i] = cornerId(in.mesh, plan.curves, t[i]);
                }
                if (side == CutSide::plus) {
                    std::swap(c[1], c[2]);
                }
                plan.triangles.push_back({c, side, SurfaceKind::wall, label});
            }
        }
    }
}

/// `ofVertex` and `ofNode` give positions, current or at rest. Summed about a corner: about a far
/// origin rounding would be all that is left.
template <class OfVertex, class OfNode>
double volumeChange(const SurfaceMesh& mesh, const StepPlan& plan, const OfVertex& ofVertex,
                    const OfNode& ofNode) {
    const auto at = [&](int corner) -> const Vec3& {
        return corner < mesh.vertexCount() ? ofVertex(corner)
                                           : ofNode(plan.curves.nodes[corner - mesh.vertexCount()]);
    };
    if (plan.triangles.empty()) {
        return 0;
    }
    const Vec3& o = at(plan.triangles.front().corners[0]);
    double added = 0;
    for (const NewTriangle& t : plan.triangles) {
        added +=
            tetrahedronVolume(at(t.corners[0]) - o, at(t.corners[1]) - o, at(t.corners[2]) - o);
    }
    double removed = 0;
    for (const int t : plan.subdivision.replaced) {
        const Triangle& c = mesh.triangle(t);
        removed += tetrahedronVolume(ofVertex(c[0]) - o, ofVertex(c[1]) - o, ofVertex(c[2]) - o);
    }
    return added - removed;
}

void measureVolumeChange(const StepInput& in, StepPlan& plan) {
    const SurfaceMesh& mesh = in.mesh;
    plan.restVolumeChange = volumeChange(
        mesh, plan, [&](int v) -> const Vec3& { return mesh.restPosition(v); },
        [](const CutNode& node) -> const Vec3& { return node.rest; });
    const auto lies = [](const CutNode& node) { return node.position == node.rest; };
    if (in.atRest && std::ranges::all_of(plan.curves.nodes, lies)) {
        plan.volumeChange = plan.restVolumeChange;
        return;
    }
    plan.volumeChange = volumeChange(
        mesh, plan, [&](int v) -> const Vec3& { return mesh.position(v); },
        [](const CutNode& node) -> const Vec3& { return node.position; });
}

/// That of the walls of one side.
SweptArea sweptArea(const StepInput& in, const StepPlan& plan) {
    const SurfaceMesh& mesh = in.mesh;
    SweptArea swept;
    for (const NewTriangle& t : plan.triangles) {
        if (t.side != CutSide::plus) {
            continue;
        }
        Corners now;
        Corners rest;
        for (int i = 0; i < 3; ++i) {
            const int corner = t.corners[i];
            if (corner < mesh.vertexCount()) {
                rest[i] = mesh.restPosition(corner);
                now[i] = in.atRest ? rest[i] : mesh.position(corner);
            } else {
                const CutNode& node = plan.curves.nodes[corner - mesh.vertexCount()];
                rest[i] = node.rest;
                now[i] = node.position;
            }
        }
        swept.add({triangleArea(now), triangleArea(rest)});
    }
    return swept;
}

void requireFinite(const CutCurves& curves) {
    for (const CutNode& node : curves.nodes) {
        if (!node.position.allFinite() || !node.rest.allFinite() || !node.velocity.allFinite()) {
            throw StepFailure{"a new vertex is not finite"};
        }
    }
}

// Strip, curves and outline. The new rung has no nodes at the parameters `skipped`.
Strip layOut(const StepInput& in, const std::vector<double>& skipped, StepPlan& plan) {
    pausePoint();
    PredicatePositions positions(in);
    Strip strip = buildStrip(in, positions, skipped);
    if (in.attempt.staysInPlane) {
        seeFlushAside(in, strip, positions);
    }
    plan.endA = airNode(strip, strip.newRung.front(), in.span.from);
    plan.endB = airNode(strip, strip.newRung.back(), in.span.to);
    plan.curves = intersect(in, strip, positions);
    pausePoint();
    plan.outline = traceOutline(in, strip, RestGuess(in, strip, plan.curves), plan.curves);
    return strip;
}

// Of inner points of the new front that lie close to one of its ends on the surface. The material
// could carry them out through the surface, which is only known roughly there.
std::vector<double> crowdedParameters(const StepInput& in, const StepPlan& plan) {
    std::vector<double> crowded;
    const auto isEnd = [&](const FrontPoint& p) {
        return plan.curves.nodes[p.node].kind != NodeKind::wall;
    };
    const std::vector<FrontPoint>& front = plan.outline.front;
    for (std::size_t i = 0; i + 1 < front.size(); ++i) {
        const double length = (plan.curves.nodes[front[i].node].position -
                               plan.curves.nodes[front[i + 1].node].position)
                                  .norm();
        if (!front[i].attached || isEnd(front[i]) == isEnd(front[i + 1])) {
            continue;
        }
        const FrontPoint& end = isEnd(front[i]) ? front[i] : front[i + 1];
        const double edge = in.edgeLengths.localEdgeLength(plan.curves.nodes[end.node].rest);
        if (length < kRoomAtFrontEnd * edge) {
            crowded.push_back(isEnd(front[i]) ? front[i + 1].s : front[i].s);
        }
    }
    return crowded;
}

}  // namespace

PlannedStep planStep(const StepInput& in) {
    PlannedStep step;
    StepPlan& plan = step.plan;
    Strip strip = layOut(in, {}, plan);
    if (const std::vector<double> crowded = crowdedParameters(in, plan); !crowded.empty()) {
        strip = layOut(in, crowded, plan);
    }
    pausePoint();
    if (plan.outline.edges.empty()) {
        step.air = AirStep{plan.endA, plan.endB};
        return step;
    }
    addSeams(in, plan.curves);
    plan.subdivision = subdivide(in.mesh, plan.curves, kCloseNoise * in.h);
    pausePoint();
    const std::vector<WallSheet> sheets = triangulateWall(in, strip, plan.outline, plan.curves);
    pausePoint();
    mapFromSkin(in, sheets, plan.curves);
    pausePoint();
    plan.retraces = !in.opening.empty();
    plan.triangles = plan.subdivision.triangles;
    addWalls(in, sheets, plan);
    plan.partners = glue(in.mesh, plan.curves, plan.outline, plan.subdivision, plan.triangles);
    pausePoint();
    measureVolumeChange(in, plan);
    requireFinite(plan.curves);
    step.swept = sweptArea(in, plan);
    step.seeds = countSeeds(in.mesh, plan.subdivision.replaced);
    step.wallTriangles = sizeOf(plan.triangles) - sizeOf(plan.subdivision.triangles);
    return step;
}

}  // namespace kerf::cut

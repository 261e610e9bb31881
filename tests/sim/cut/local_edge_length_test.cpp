#include "sim/cut/surface/edge_length_field.h"

namespace kerf {
namespace {

using cut::EdgeLengthField;

double median(std::vector<double> values) {
    EXPECT_FALSE(values.empty());
    if (values.empty()) {
        return 0;
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Of edges of triangles of one kind whose middle has an x within [low, high].
double medianEdge(const SurfaceMesh& mesh, SurfaceKind kind, double low, double high) {
    std::vector<double> lengths;
    for (int h = 0; h < 3 * mesh.triangleSlots(); ++h) {
        if (!mesh.alive(h / 3) || mesh.kind(h / 3) != kind) {
            continue;
        }
        const Vec3& a = mesh.restPosition(mesh.origin(h));
        const Vec3& b = mesh.restPosition(mesh.target(h));
        const double x = 0.5 * (a.x() + b.x());
        if (low <= x && x <= high) {
            lengths.push_back((b - a).norm());
        }
    }
    return median(std::move(lengths));
}

/// Half about the y axis, away from where it rests.
SurfaceMesh turned(SurfaceMesh mesh) {
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3& rest = mesh.restPosition(v);
        mesh.setPosition(v, {-rest.x(), rest.y(), -rest.z()});
    }
    return mesh;
}

struct Ratios {
    double fine;    ///< median of wall edges over that of the uncut skin's, where the skin is fine
    double coarse;  ///< where it is coarse
};

Ratios ratiosAfter(const SurfaceMesh& body, const Stroke& stroke, const CutSettings& settings) {
    SurfaceMesh mesh = body;
    Cutter cutter(mesh, settings);
    const CutCheck check = runStroke(cutter, mesh, stroke);
    EXPECT_EQ(check.problem, "");
    EXPECT_EQ(check.refused, 0);
    EXPECT_GT(check.cuts, 0);
    const auto ratio = [&](double low, double high) {
        return medianEdge(mesh, SurfaceKind::wall, low, high) /
               medianEdge(body, SurfaceKind::skin, low, high);
    };
    return {ratio(0.35, 0.5), ratio(-0.5, -0.35)};
}

TEST(EdgeLengthField, IsTheMeanEverywhereInAnEvenBody) {
    for (const SurfaceMesh& mesh : {icosphere(3), cubeSphere(8), test::torus()}) {
        const EdgeLengthField field = EdgeLengthField::ofSkin(mesh);
        EXPECT_TRUE(field.isEven());
        EXPECT_EQ(field.localEdgeLength(Vec3(0.1, 0.2, 0.3)), field.mean());
    }
}

TEST(EdgeLengthField, FollowsTheSkinAndGrowsSmoothlyInside) {
    const SurfaceMesh mesh = gradedSphere();
    const EdgeLengthField field = EdgeLengthField::ofSkin(mesh);
    ASSERT_FALSE(field.isEven());
    const double diagonal = std::sqrt(3.0);
    for (const auto& [low, high] : {std::pair(-0.5, -0.4), {-0.1, 0.1}, {0.4, 0.5}}) {
        const double skin = std::min(medianEdge(mesh, SurfaceKind::skin, low, high), diagonal / 12);
        const double there = field.localEdgeLength(Vec3(0.5 * (low + high), 0, 0));
        EXPECT_GT(there, skin / 1.8) << "x from " << low;
        EXPECT_LT(there, skin * 1.8) << "x from " << low;
    }
    double before = field.localEdgeLength(Vec3(-0.5, 0.01, 0.02));
    for (double x = -0.5; x <= 0.5; x += 0.01) {
        const double here = field.localEdgeLength(Vec3(x, 0.01, 0.02));
        EXPECT_LT(here, 1.05 * before) << "x " << x;
        EXPECT_GT(here, 0.8 * before) << "x " << x;
        before = here;
    }
}

TEST(EdgeLengthField, DividesAPieceWhereItsEdgesBelong) {
    const EdgeLengthField even(0.1);
    const std::vector<double> thirds =
        cut::divideByEdgeLength(even, Vec3::Zero(), Vec3(0.31, 0, 0), 0.31);
    ASSERT_EQ(thirds.size(), 3U);
    EXPECT_NEAR(thirds[0], 1.0 / 3, 1e-15);
    EXPECT_NEAR(thirds[1], 2.0 / 3, 1e-15);
    EXPECT_EQ(thirds[2], 1);

    const EdgeLengthField graded = EdgeLengthField::ofSkin(gradedSphere());
    const Vec3 from(-0.45, 0, 0);
    const Vec3 way(0.9, 0, 0);
    double at = 0;
    for (const double share : cut::divideByEdgeLength(graded, from, from + way, way.norm())) {
        const double wanted = graded.localEdgeLength(from + way * (0.5 * (at + share)));
        EXPECT_GT((share - at) * way.norm(), 0.7 * wanted) << "at " << at;
        EXPECT_LT((share - at) * way.norm(), 1.4 * wanted) << "at " << at;
        at = share;
    }
    EXPECT_EQ(at, 1);
}

// A blade along the way from fine to coarse has one distance between its rows, half of an edge
// about its middle. A blade across it comes from one to the other.
TEST(LocalEdgeLength, WallsOfAGradedBodyAreAsFineAsTheSkinBeside) {
    const Vec3 center(0.003, 0.002, 0.011);
    struct Case {
        const char* name;
        Stroke stroke;
    };
    const std::vector<Case> cases{
        {"blade along", straightStroke(center, Vec3::UnitX(), -Vec3::UnitY(), 3, 2.4, 240)},
        {"blade across", straightStroke(center, Vec3::UnitY(), Vec3::UnitX(), 3, 2.4, 240)},
        {"swipe", straightStroke(center, Vec3::UnitX(), -Vec3::UnitY(), 3, 2.4, 2)}};
    for (const auto& [bodyName, body] :
         {std::pair("sphere", gradedSphere()), std::pair("torus", gradedTorus())}) {
        for (const Case& c : cases) {
            CutSettings even = exactSettings();
            even.wallEdgeLength = EdgeLengthField::ofSkin(body).mean();
            const Ratios before = ratiosAfter(body, c.stroke, even);
            const Ratios local = ratiosAfter(body, c.stroke, exactSettings());
            std::cout << bodyName << ", " << c.name << ": fine " << before.fine << " -> "
                      << local.fine << ", coarse " << before.coarse << " -> " << local.coarse
                      << "\n";
            EXPECT_GT(local.fine, 0.5) << bodyName << ", " << c.name;
            EXPECT_LT(local.fine, 2.0) << bodyName << ", " << c.name;
            EXPECT_GT(local.coarse, 0.4) << bodyName << ", " << c.name;
            EXPECT_LT(local.coarse, 2.0) << bodyName << ", " << c.name;
            EXPECT_GT(local.coarse, 1.6 * before.coarse) << bodyName << ", " << c.name;
        }
    }
}

// Edge lengths are those of the place at rest, which for new points of a wall is a guess.
TEST(LocalEdgeLength, SoTheyAreWhereItHasTurned) {
    const Vec3 center(0.003, 0.002, 0.011);
    const SurfaceMesh body = turned(gradedSphere());
    for (const int steps : {2, 240}) {
        const Ratios ratios =
            ratiosAfter(body, straightStroke(center, Vec3::UnitX(), -Vec3::UnitY(), 3, 2.4, steps),
                        exactSettings());
        EXPECT_GT(ratios.fine, 0.5) << steps;
        EXPECT_LT(ratios.fine, 2.0) << steps;
        EXPECT_GT(ratios.coarse, 0.4) << steps;
        EXPECT_LT(ratios.coarse, 2.0) << steps;
    }
}

}  // namespace
}  // namespace kerf

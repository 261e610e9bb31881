#include <gtest/gtest.h>

#include "sim/cut/blade.h"
#include "sim/cut/cut_types.h"
#include "sim/mesh/invariants.h"
#include "sim/mesh/union_find.h"
#include "tests/support/cut_strokes.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

using test::CutCheck;
using test::Stroke;

// Of the blade, share of an edge: the parts differ by the volume that it has swept.
constexpr double kOffset = 1e-10;

/// Pieces that the plane makes, independent of the cutter: vertices joined by edges that stay on
/// one side. Right where no part's cap has a hole.
int partsBeside(const SurfaceMesh& mesh, const Vec3& point, const Vec3& normal) {
    UnionFind parts(mesh.vertexCount());
    const auto side = [&](int v) { return (mesh.position(v) - point).dot(normal) > 0; };
    std::set<int> roots;
    for (int h = 0; h < 3 * mesh.triangleSlots(); ++h) {
        if (side(mesh.origin(h)) == side(mesh.target(h))) {
            parts.join(mesh.origin(h), mesh.target(h));
        }
    }
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        roots.insert(parts.root(v));
    }
    return static_cast<int>(roots.size());
}

void expectPlanarHalves(SurfaceMesh mesh, bool cleanUp, const Stroke& stroke, const Vec3& point,
                        const Vec3& normal, int pieces) {
    const test::HalfSpaceVolumes expected = test::clipVolumes(mesh, point, normal);
    const double whole = meshVolume(mesh);
    CutSettings settings = test::exactSettings();
    settings.offset = kOffset;
    settings.tolerance = 0.01 * kOffset;
    settings.cleanUp = cleanUp;
    const CutCheck check = test::runStroke(mesh, settings, stroke);
    EXPECT_EQ(check.problem, "");
    EXPECT_EQ(check.unmirrored, "");
    EXPECT_EQ(check.refused, 0);
    EXPECT_GT(check.cuts, 0);
    const PieceMap map = findPieces(mesh);
    EXPECT_EQ(static_cast<int>(map.pieces.size()), pieces);
    double above = 0;
    double below = 0;
    for (int p = 0; p < static_cast<int>(map.pieces.size()); ++p) {
        (test::meanSide(mesh, map, p, point, normal) > 0 ? above : below) += map.pieces[p].volume;
    }
    const double tolerance = (cleanUp ? 1e-7 : 1e-9) * whole;
    EXPECT_NEAR(above, expected.above, tolerance);
    EXPECT_NEAR(below, expected.below, tolerance);
    EXPECT_NEAR(above + below, whole, tolerance);
}

void expectPlanarHalves(const SurfaceMesh& mesh, const Stroke& stroke, const Vec3& point,
                        const Vec3& normal, int pieces) {
    for (const bool cleanUp : {false, true}) {
        SCOPED_TRACE(cleanUp ? "with clean-up" : "without clean-up");
        expectPlanarHalves(mesh, cleanUp, stroke, point, normal, pieces);
    }
}

/// Blade along `along`, moving in direction `travel`, through `center`; it clears a unit body.
Stroke planarStroke(const Vec3& center, const Vec3& along, const Vec3& travel, int steps) {
    return test::straightStroke(center, along, travel, 3.0, 2.4, steps);
}

TEST(PlanarCut, SphereInTwo) {
    const Vec3 center(0.013, 0.021, 0.034);
    expectPlanarHalves(test::icosphere(3), planarStroke(center, Vec3::UnitX(), -Vec3::UnitY(), 60),
                       center, Vec3::UnitZ(), 2);
}

TEST(PlanarCut, CoarseSpheresInTwo) {
    const Vec3 center(0.013, 0.021, 0.034);
    for (const int subdivisions : {0, 1}) {
        expectPlanarHalves(test::icosphere(subdivisions),
                           planarStroke(center, Vec3::UnitX(), -Vec3::UnitY(), 60), center,
                           Vec3::UnitZ(), 2);
    }
}

TEST(PlanarCut, TorusAcrossGivesTwoArches) {
    const Vec3 center(0.003, 0.001, 0.007);
    expectPlanarHalves(test::torus(), planarStroke(center, Vec3::UnitX(), -Vec3::UnitY(), 60),
                       center, Vec3::UnitZ(), 2);
}

TEST(PlanarCut, TorusInItsPlaneGivesTwoRings) {
    const Vec3 center(0.003, 0.0012, 0.007);
    expectPlanarHalves(test::torus(), planarStroke(center, Vec3::UnitX(), Vec3::UnitZ(), 60),
                       center, Vec3::UnitY(), 2);
}

TEST(PlanarCut, BentTubeInTwo) {
    const Vec3 center(0.02, 0.01, 0.0);
    expectPlanarHalves(test::bentTube(), planarStroke(center, Vec3::UnitZ(), -Vec3::UnitY(), 60),
                       center, Vec3::UnitX(), 2);
}

TEST(PlanarCut, ThroughVerticesAndAlongEdges) {
    // The planes z = 0 and x = 0 hold vertices and edges of the icosphere and of the torus.
    for (const SurfaceMesh& mesh : {test::icosphere(2), test::torus(), test::cubeSphere(8)}) {
        expectPlanarHalves(mesh, planarStroke(Vec3::Zero(), Vec3::UnitX(), -Vec3::UnitY(), 48),
                           Vec3::Zero(), Vec3::UnitZ(), 2);
        expectPlanarHalves(mesh, planarStroke(Vec3::Zero(), Vec3::UnitZ(), -Vec3::UnitY(), 48),
                           Vec3::Zero(), Vec3::UnitX(), 2);
    }
}

TEST(PlanarCut, InOneGiantStep) {
    const Vec3 center(0.003, 0.0012, 0.007);
    expectPlanarHalves(test::torus(), planarStroke(center, Vec3::UnitX(), Vec3::UnitZ(), 1), center,
                       Vec3::UnitY(), 2);
    expectPlanarHalves(test::icosphere(3), planarStroke(center, Vec3::UnitX(), Vec3::UnitZ(), 1),
                       center, Vec3::UnitY(), 2);
}

TEST(PlanarCut, OctopusLosesItsArmsToOnePlane) {
    const SurfaceMesh octopus = test::builtin("octopus");
    const Bounds bounds = meshBounds(octopus);
    for (const int axis : {1, 2}) {
        SCOPED_TRACE("axis " + std::to_string(axis));
        const Vec3 normal = Vec3::Unit(axis);
        const Vec3 center = bounds.center() - 0.171 * bounds.diagonal() * normal;
        const int parts = partsBeside(octopus, center, normal);
        EXPECT_GT(parts, 1);
        expectPlanarHalves(
            octopus,
            test::straightStroke(center, Vec3::Unit((axis + 1) % 3), Vec3::Unit((axis + 2) % 3),
                                 2.6 * bounds.diagonal(), 2.3 * bounds.diagonal(), 40),
            center, normal, parts);
    }
}

}  // namespace
}  // namespace kerf

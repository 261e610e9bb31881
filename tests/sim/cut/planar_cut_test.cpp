#include <gtest/gtest.h>

#include "sim/cut/cutter.h"
#include "sim/mesh/invariants.h"
#include "tests/support/cut_strokes.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

using test::CutCheck;
using test::Stroke;

void expectHalves(SurfaceMesh mesh, bool cleanUp, const Stroke& stroke, const Vec3& point,
                  const Vec3& normal, int pieces) {
    const test::HalfSpaceVolumes expected = test::clipVolumes(mesh, point, normal);
    const double whole = meshVolume(mesh);
    CutSettings settings = test::exactSettings();
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
    // The blade is offset by 1e-7 of an edge, so the parts differ by that much area swept.
    EXPECT_NEAR(above, expected.above, 1e-7 * whole);
    EXPECT_NEAR(below, expected.below, 1e-7 * whole);
    EXPECT_NEAR(above + below, whole, (cleanUp ? 1e-7 : 1e-9) * whole);
}

void expectHalves(const SurfaceMesh& mesh, const Stroke& stroke, const Vec3& point,
                  const Vec3& normal, int pieces) {
    for (const bool cleanUp : {false, true}) {
        SCOPED_TRACE(cleanUp ? "with clean-up" : "without clean-up");
        expectHalves(mesh, cleanUp, stroke, point, normal, pieces);
    }
}

/// Blade along `along`, moving in direction `travel`, through `center`; it clears a unit body.
Stroke planarStroke(const Vec3& center, const Vec3& along, const Vec3& travel, int steps) {
    return test::straightStroke(center, along, travel, 3.0, 2.4, steps);
}

TEST(PlanarCut, SphereInTwo) {
    const Vec3 center(0.013, 0.021, 0.034);
    expectHalves(test::icosphere(3), planarStroke(center, Vec3::UnitX(), -Vec3::UnitY(), 60),
                 center, Vec3::UnitZ(), 2);
}

TEST(PlanarCut, CoarseSpheresInTwo) {
    const Vec3 center(0.013, 0.021, 0.034);
    for (const int subdivisions : {0, 1}) {
        expectHalves(test::icosphere(subdivisions),
                     planarStroke(center, Vec3::UnitX(), -Vec3::UnitY(), 60), center, Vec3::UnitZ(),
                     2);
    }
}

TEST(PlanarCut, TorusAcrossGivesTwoArches) {
    const Vec3 center(0.003, 0.001, 0.007);
    expectHalves(test::torus(), planarStroke(center, Vec3::UnitX(), -Vec3::UnitY(), 60), center,
                 Vec3::UnitZ(), 2);
}

TEST(PlanarCut, TorusInItsPlaneGivesTwoRings) {
    const Vec3 center(0.003, 0.0012, 0.007);
    expectHalves(test::torus(), planarStroke(center, Vec3::UnitX(), Vec3::UnitZ(), 60), center,
                 Vec3::UnitY(), 2);
}

TEST(PlanarCut, BentTubeInTwo) {
    const Vec3 center(0.02, 0.01, 0.0);
    expectHalves(test::bentTube(), planarStroke(center, Vec3::UnitZ(), -Vec3::UnitY(), 60), center,
                 Vec3::UnitX(), 2);
}

TEST(PlanarCut, ThroughVerticesAndAlongEdges) {
    // The planes z = 0 and x = 0 hold vertices and edges of the icosphere and of the torus.
    for (const SurfaceMesh& mesh : {test::icosphere(2), test::torus(), test::cubeSphere(8)}) {
        expectHalves(mesh, planarStroke(Vec3::Zero(), Vec3::UnitX(), -Vec3::UnitY(), 48),
                     Vec3::Zero(), Vec3::UnitZ(), 2);
        expectHalves(mesh, planarStroke(Vec3::Zero(), Vec3::UnitZ(), -Vec3::UnitY(), 48),
                     Vec3::Zero(), Vec3::UnitX(), 2);
    }
}

TEST(PlanarCut, InOneGiantStep) {
    const Vec3 center(0.003, 0.0012, 0.007);
    expectHalves(test::torus(), planarStroke(center, Vec3::UnitX(), Vec3::UnitZ(), 1), center,
                 Vec3::UnitY(), 2);
    expectHalves(test::icosphere(3), planarStroke(center, Vec3::UnitX(), Vec3::UnitZ(), 1), center,
                 Vec3::UnitY(), 2);
}

}  // namespace
}  // namespace kerf

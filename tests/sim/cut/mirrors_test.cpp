#include <gtest/gtest.h>

#include "sim/cut/plan/plan.h"
#include "tests/support/facing_walls.h"

namespace kerf::cut {
namespace {

constexpr double kClose = 1e-4;

class Mirrors : public ::testing::Test {
  protected:
    bool holds(const SurfaceMesh& body, const test::DrawnCurves& drawn) const {
        StepPlan plan;
        plan.curves = drawn.curves;
        plan.subdivision = subdivide(body, plan.curves, kClose);
        return keepsMirrors(body, plan, kClose);
    }
    /// A segment from one middle of an edge of the wall to another, without a partner.
    test::DrawnCurves drawnOnOne(const SurfaceMesh& body) const {
        test::DrawnCurves drawn(body);
        const Triangle& c = body.triangle(wall);
        drawn.segment(wall, drawn.onEdge(c[0], c[1], 0.5, 0), drawn.onEdge(c[1], c[2], 0.5, 0), 0);
        return drawn;
    }

    SurfaceMesh mesh = test::halvedBox(0);
    int wall = test::wallsOfPlus(mesh)[3];
    int mirror = test::mirrorOf(mesh, wall);
};

TEST_F(Mirrors, AreKeptWhereBothWallsAreDividedAlike) {
    EXPECT_TRUE(holds(mesh, test::drawnOnBoth(mesh, wall, mirror)));
}

TEST_F(Mirrors, AreLostWhereOneWallAloneIsDivided) {
    EXPECT_FALSE(holds(mesh, drawnOnOne(mesh)));
}

TEST_F(Mirrors, AreLostWhereTheWallsTakeDifferentNodes) {
    test::DrawnCurves drawn = test::drawnOnBoth(mesh, wall, mirror);
    drawn.inFace(wall, {0.6, 0.2, 0.2}, 8);
    drawn.inFace(mirror, {0.6, 0.2, 0.2}, 9);
    EXPECT_FALSE(holds(mesh, drawn));
}

TEST_F(Mirrors, AreLostWhereTheWallsTakeANodeAtDifferentPlaces) {
    test::DrawnCurves drawn = test::drawnOnBoth(mesh, wall, mirror);
    drawn.inFace(wall, {0.8, 0.1, 0.1}, 8);
    drawn.inFace(mirror, {0.34, 0.33, 0.33}, 8);
    EXPECT_FALSE(holds(mesh, drawn));
}

TEST_F(Mirrors, OfASlitThatStandsOpenDoNotCount) {
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3 apart(0, 0, 10 * kClose * v);
        mesh.setPosition(v, mesh.position(v) + apart);
    }
    EXPECT_TRUE(holds(mesh, drawnOnOne(mesh)));
}

TEST_F(Mirrors, OfTheSkinThereAreNone) {
    test::DrawnCurves drawn(mesh);
    int skin = -1;
    for (const int t : livingTriangles(mesh)) {
        skin = mesh.kind(t) == SurfaceKind::skin ? t : skin;
    }
    drawn.segment(skin, drawn.inFace(skin, {0.2, 0.2, 0.6}, 0),
                  drawn.inFace(skin, {0.6, 0.2, 0.2}, 1), 0);
    EXPECT_TRUE(holds(mesh, drawn));
}

}  // namespace
}  // namespace kerf::cut

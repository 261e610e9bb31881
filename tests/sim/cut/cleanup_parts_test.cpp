#include "sim/cut/plan/edge_repair.h"
#include "sim/cut/plan/plan.h"

namespace kerf::cut {
namespace {

constexpr int kManyNumbers = 4;  // subdivisions: neighbours whose numbers share bits

// Two neighbours of a vertex become one: both of its edges have the same ends then.
void joinTwoNeighbours(SurfaceMesh& mesh, int v) {
    std::vector<int> neighbours;
    mesh.forEachOutgoing(v, [&](int h) { neighbours.push_back(mesh.target(h)); });
    const int kept = neighbours[0];
    const int gone = neighbours[2];
    for (int h = 0; h < 3 * mesh.triangleSlots(); ++h) {
        if (mesh.origin(h) == gone) {
            mesh.setCorner(h / 3, h % 3, kept);
        }
    }
}

Umbrellas umbrellasOf(const SurfaceMesh& mesh) {
    Umbrellas all;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        mesh.forEachOutgoing(v, [&](int h) { all.spokes.push_back(h); });
        all.ends.push_back(static_cast<int>(all.spokes.size()));
    }
    return all;
}

TEST(CutEdgeRepair, FindsTwoEdgesWithTheSameEnds) {
    const SurfaceMesh whole = icosphere(kManyNumbers);
    const Umbrellas umbrellas = umbrellasOf(whole);
    EXPECT_FALSE(hasDuplicateEdges(whole, umbrellas));
    for (int v = 0; v < whole.vertexCount(); v += 97) {
        SurfaceMesh mesh = whole;
        joinTwoNeighbours(mesh, v);
        EXPECT_TRUE(hasDuplicateEdges(mesh, umbrellas)) << "vertex " << v;
        EXPECT_FALSE(hasDuplicateEdges(mesh, {})) << "vertex " << v;
    }
}

constexpr double kClose = 1e-4;

class Mirrors : public ::testing::Test {
  protected:
    bool holds(const SurfaceMesh& body, const DrawnCurves& drawn) const {
        StepPlan plan;
        plan.curves = drawn.curves;
        plan.subdivision = subdivide(body, plan.curves, kClose);
        return keepsMirrors(body, plan, kClose);
    }
    /// A segment from one middle of an edge of the wall to another, without a partner.
    DrawnCurves drawnOnOne(const SurfaceMesh& body) const {
        DrawnCurves drawn(body);
        const Triangle& c = body.triangle(wall);
        drawn.segment(wall, drawn.onEdge(c[0], c[1], 0.5, 0), drawn.onEdge(c[1], c[2], 0.5, 0), 0);
        return drawn;
    }

    SurfaceMesh mesh = halvedBox(0);
    int wall = wallsOfPlus(mesh)[3];
    int mirror = test::mirrorOf(mesh, wall);
};

TEST_F(Mirrors, AreKeptWhereBothWallsAreDividedAlike) {
    EXPECT_TRUE(holds(mesh, drawnOnBoth(mesh, wall, mirror)));
}

TEST_F(Mirrors, AreLostWhereOneWallAloneIsDivided) {
    EXPECT_FALSE(holds(mesh, drawnOnOne(mesh)));
}

TEST_F(Mirrors, AreLostWhereTheWallsTakeDifferentNodes) {
    DrawnCurves drawn = drawnOnBoth(mesh, wall, mirror);
    drawn.inFace(wall, {0.6, 0.2, 0.2}, 8);
    drawn.inFace(mirror, {0.6, 0.2, 0.2}, 9);
    EXPECT_FALSE(holds(mesh, drawn));
}

TEST_F(Mirrors, AreLostWhereTheWallsTakeANodeAtDifferentPlaces) {
    DrawnCurves drawn = drawnOnBoth(mesh, wall, mirror);
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
    DrawnCurves drawn(mesh);
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

#include "sim/mesh/invariants.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace kerf {
namespace {

using ::testing::HasSubstr;

/// The local check, of every triangle.
std::string checkEverywhere(const SurfaceMesh& mesh) {
    std::vector<int> all(mesh.triangleSlots());
    std::iota(all.begin(), all.end(), 0);
    return checkClosedManifoldAround(mesh, all);
}

class SoundShapes : public ::testing::TestWithParam<SurfaceMesh> {};

TEST_P(SoundShapes, PassEveryCheck) {
    EXPECT_EQ(checkClosedManifold(GetParam()), "");
    EXPECT_EQ(checkEverywhere(GetParam()), "");
}

INSTANTIATE_TEST_SUITE_P(Invariants, SoundShapes,
                         ::testing::Values(test::icosphere(0), test::icosphere(2),
                                           test::cubeSphere(8), test::torus(), test::bentTube(),
                                           test::box(Vec3(1, 2, 3), 3)));

TEST(Invariants, TwinMissing) {
    SurfaceMesh mesh = test::icosphere(0);
    mesh.setTwin(7, -1);
    EXPECT_THAT(checkTwins(mesh), HasSubstr("half-edge 7"));
    EXPECT_NE(checkClosedManifoldAround(mesh, std::vector<int>{2}), "");
    EXPECT_EQ(checkClosedManifoldAround(mesh, std::vector<int>{}), "");
    EXPECT_NE(checkClosedManifold(mesh), "");
}

TEST(Invariants, TwinNotMutual) {
    SurfaceMesh mesh = test::icosphere(0);
    mesh.setTwin(7, mesh.twin(8));
    EXPECT_THAT(checkTwins(mesh), HasSubstr("whose twin is another"));
    EXPECT_NE(checkEverywhere(mesh), "");
}

TEST(Invariants, TwinWithOtherEndPoints) {
    SurfaceMesh mesh = test::icosphere(0);
    const int g = mesh.twin(7);
    const int f = mesh.twin(8);
    mesh.setTwin(7, f);
    mesh.setTwin(f, 7);
    mesh.setTwin(8, g);
    mesh.setTwin(g, 8);
    EXPECT_THAT(checkTwins(mesh), HasSubstr("other end points"));
    EXPECT_NE(checkEverywhere(mesh), "");
}

TEST(Invariants, TwinInDeadTriangle) {
    SurfaceMesh mesh = test::icosphere(0);
    mesh.removeTriangle(3);
    EXPECT_THAT(checkTwins(mesh), HasSubstr("no living twin"));
    EXPECT_NE(checkEverywhere(mesh), "");
}

TEST(Invariants, CornerOutOfRange) {
    SurfaceMesh mesh = test::icosphere(0);
    mesh.setCorner(4, 1, mesh.vertexCount());
    EXPECT_THAT(checkTwins(mesh), HasSubstr("triangle 4 names vertex 12 of 12"));
    EXPECT_NE(checkUmbrellas(mesh), "");
    EXPECT_NE(checkSimpleComplex(mesh), "");
}

TEST(Invariants, OutgoingHalfEdgeOfAnotherVertex) {
    SurfaceMesh mesh = test::icosphere(0);
    mesh.setOutgoing(5, mesh.outgoing(6));
    EXPECT_THAT(checkUmbrellas(mesh), HasSubstr("vertex 5"));
    EXPECT_NE(checkEverywhere(mesh), "");
}

TEST(Invariants, OutgoingHalfEdgeOfUnusedVertex) {
    SurfaceMesh mesh = test::icosphere(0);
    const int v = mesh.addVertex(Vec3::Zero(), Vec3::Zero(), Vec3::Zero());
    EXPECT_EQ(checkClosedManifold(mesh), "");
    mesh.setOutgoing(v, 0);
    EXPECT_THAT(checkUmbrellas(mesh), HasSubstr("vertex 12"));
}

/// Two tetrahedra that share vertex 0 and nothing else.
TEST(Invariants, TwoUmbrellasAtOneVertex) {
    const SurfaceMesh mesh = SurfaceMesh::fromTriangles(
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
        {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}, {4, 6, 5}});
    EXPECT_EQ(checkTwins(mesh), "");
    EXPECT_EQ(checkSimpleComplex(mesh), "");
    EXPECT_THAT(checkUmbrellas(mesh), HasSubstr("vertex 0 holds 3 of its 6"));
    EXPECT_NE(checkEverywhere(mesh), "");
}

TEST(Invariants, UmbrellaThatDoesNotClose) {
    SurfaceMesh mesh = test::icosphere(0);
    const int v = mesh.origin(7);
    int other = -1;
    mesh.forEachOutgoing(v, [&](int h) { other = h; });
    mesh.setTwin(SurfaceMesh::previous(other), SurfaceMesh::next(other));
    EXPECT_NE(checkUmbrellas(mesh), "");
}

TEST(Invariants, TwoEdgesBetweenTheSameVertices) {
    SurfaceMesh mesh = test::icosphere(0);
    const int t = 0;
    const Triangle corners = mesh.triangle(t);
    mesh.addTriangle({corners[0], corners[1], corners[2]}, SurfaceKind::skin, -1);
    EXPECT_THAT(checkSimpleComplex(mesh), HasSubstr("two edges run between"));
}

TEST(Invariants, EdgeFromAVertexToItself) {
    SurfaceMesh mesh = test::icosphere(0);
    mesh.setCorner(2, 1, mesh.triangle(2)[0]);
    EXPECT_THAT(checkSimpleComplex(mesh), HasSubstr("starts and ends at one vertex"));
}

TEST(Invariants, NotFinite) {
    const Vec3 bad(0, std::numeric_limits<double>::quiet_NaN(), 0);
    SurfaceMesh mesh = test::icosphere(0);
    mesh.setPosition(3, bad);
    EXPECT_THAT(checkFinite(mesh), HasSubstr("vertex 3"));
    EXPECT_NE(checkEverywhere(mesh), "");
    mesh = test::icosphere(0);
    mesh.setRestPosition(4, bad);
    EXPECT_THAT(checkFinite(mesh), HasSubstr("vertex 4"));
    mesh = test::icosphere(0);
    mesh.setVelocity(5, Vec3(0, 0, std::numeric_limits<double>::infinity()));
    EXPECT_THAT(checkClosedManifold(mesh), HasSubstr("vertex 5"));
}

TEST(Measures, VolumeOfABox) {
    SurfaceMesh mesh = test::box(Vec3(1, 2, 3), 2);
    EXPECT_NEAR(meshVolume(mesh), 6, 1e-12);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        mesh.setPosition(v, 2 * mesh.position(v) + Vec3(5, 6, 7));
    }
    EXPECT_NEAR(meshVolume(mesh), 48, 1e-9);
    EXPECT_NEAR(meshRestVolume(mesh), 6, 1e-12);
    EXPECT_LT((meshBounds(mesh).low - Vec3(4, 4, 4)).norm(), 1e-12);
    EXPECT_LT((meshBounds(mesh).high - Vec3(6, 8, 10)).norm(), 1e-12);
}

TEST(Measures, VolumeOfATorus) {
    const SurfaceMesh mesh = test::torus(256, 128, 0.35, 0.15);
    const double exact = 2 * std::numbers::pi * std::numbers::pi * 0.35 * 0.15 * 0.15;
    EXPECT_NEAR(meshVolume(mesh), exact, 1e-3 * exact);
}

TEST(Pieces, OrderedByTheirLowestVertex) {
    SurfaceMesh mesh =
        test::meshOf(test::joined(test::boxSoup(), test::icosphereSoup(1, 0.5), Vec3(3, 0, 0)));
    const PieceMap map = findPieces(mesh);
    ASSERT_EQ(map.pieces.size(), 2u);
    EXPECT_EQ(map.pieces[0].triangles, 12);
    EXPECT_EQ(map.pieces[0].vertices, 8);
    EXPECT_NEAR(map.pieces[0].volume, 1, 1e-12);
    EXPECT_NEAR(map.pieces[0].restArea, 6, 1e-12);
    EXPECT_EQ(map.pieces[1].triangles, 80);
    EXPECT_EQ(map.pieces[1].vertices, 42);
    EXPECT_EQ(map.ofVertex[0], 0);
    EXPECT_EQ(map.ofVertex[8], 1);
}

TEST(Pieces, DeadTrianglesAndUnusedVerticesBelongToNone) {
    SurfaceMesh mesh =
        test::meshOf(test::joined(test::boxSoup(), test::icosphereSoup(0, 0.5), Vec3(3, 0, 0)));
    for (int t = 0; t < 12; ++t) {
        mesh.removeTriangle(t);
    }
    const PieceMap map = findPieces(mesh);
    ASSERT_EQ(map.pieces.size(), 1u);
    EXPECT_EQ(map.pieces[0].triangles, 20);
    EXPECT_EQ(map.ofVertex[0], -1);
    EXPECT_EQ(map.ofVertex[8], 0);
}

}  // namespace
}  // namespace kerf

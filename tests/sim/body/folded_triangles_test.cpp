#include "sim/body/folded_triangles.h"

#include <gtest/gtest.h>

#include "sim/cut/stroke/cutter.h"
#include "sim/mesh/triangle.h"
#include "tests/support/cut_strokes.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

/// A vertex goes across the opposite edge of one of its triangles, which turns over.
SurfaceMesh foldedSphere(int vertex) {
    SurfaceMesh mesh = test::icosphere(2);
    const int h = mesh.next(mesh.outgoing(vertex));
    const Vec3 middle = 0.5 * (mesh.position(mesh.origin(h)) + mesh.position(mesh.target(h)));
    mesh.setPosition(vertex, 2.2 * middle - 1.2 * mesh.position(vertex));
    return mesh;
}

TEST(FoldedTriangles, AreThoseAroundWhatTurnedOver) {
    constexpr int kVertex = 30;
    const SurfaceMesh mesh = foldedSphere(kVertex);
    const std::vector<int> folded = foldedTriangles(mesh, 0);
    EXPECT_TRUE(std::ranges::binary_search(folded, mesh.outgoing(kVertex) / 3));
    EXPECT_LT(folded.size(), 40u);
    EXPECT_TRUE(std::ranges::is_sorted(folded));
}

TEST(FoldedTriangles, AreNoneWhereABodyOnlyTurnsAndStretches) {
    SurfaceMesh mesh = test::icosphere(2);
    const Eigen::AngleAxisd turn(2.5, Vec3(1, -2, 0.5).normalized());
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3 stretched = mesh.restPosition(v).cwiseProduct(Vec3(1.2, 0.8, 1.1));
        mesh.setPosition(v, turn * stretched);
    }
    EXPECT_TRUE(foldedTriangles(mesh, 0).empty());
}

TEST(FoldedTriangles, LieInNoSlotBeforeTheFirst) {
    constexpr int kVertex = 30;
    const SurfaceMesh mesh = foldedSphere(kVertex);
    const std::vector<int> all = foldedTriangles(mesh, 0);
    const int first = all[all.size() / 2];
    const std::vector<int> some = foldedTriangles(mesh, first);
    EXPECT_LT(some.size(), all.size());
    EXPECT_GE(some.front(), first);
    EXPECT_TRUE(foldedTriangles(mesh, mesh.triangleSlots()).empty());
}

/// The direction away from the slit in the plane z = 0 on which a vertex lies.
double sideOf(const SurfaceMesh& mesh, int vertex) {
    double side = mesh.restPosition(vertex).z();
    mesh.forEachOutgoing(vertex, [&](int h) {
        if (mesh.kind(h / 3) == SurfaceKind::wall) {
            side = -areaNormal(restCornersOf(mesh, h / 3)).z();
        }
    });
    return side > 0 ? 1 : -1;
}

TEST(FoldedTriangles, AreNotThoseAtTheEndOfASlitThatIsOpened) {
    SurfaceMesh mesh = test::icosphere(3);
    Cutter cutter(mesh, test::exactSettings());
    const test::Stroke down =
        test::straightStroke({0, 0.7, 0}, Vec3::UnitX(), -Vec3::UnitY(), 3, 1, 20);
    ASSERT_EQ(test::runStroke(cutter, mesh, down).problem, "");
    const std::vector<int> ends = test::slitHalfEdges(mesh, 0);
    ASSERT_FALSE(ends.empty());
    const double bottom = mesh.restPosition(mesh.origin(ends.front())).y();
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3& rest = mesh.restPosition(v);
        const double opening = 1.2 * std::max(0.0, rest.y() - bottom);  // by 50 degrees each
        mesh.setPosition(v, rest + Vec3(0, 0, sideOf(mesh, v) * opening));
    }
    EXPECT_EQ(foldedTriangles(mesh, 0), std::vector<int>());
}

}  // namespace
}  // namespace kerf

#include "app/import/repair/hole_filling.h"

namespace kerf::app {
namespace {

/// Without the triangles for which `gone` holds of their middle.
template <class Gone>
TriangleSoup withHoleAt(const TriangleSoup& soup, Gone&& gone) {
    TriangleSoup rest = soup;
    std::erase_if(rest.triangles, [&](const Triangle& t) {
        return gone((soup.positions[t[0]] + soup.positions[t[1]] + soup.positions[t[2]]) / 3);
    });
    return weldExactly(rest);
}

TEST(HoleFilling, AClosedSurfaceStaysAsItIs) {
    TriangleSoup soup = weldExactly(boxSoup());
    const HoleFilling done = fillHoles(soup);
    EXPECT_EQ(done.holes, 0);
    EXPECT_EQ(soup.triangles.size(), 12U);
}

TEST(HoleFilling, TheLidOfABoxComesBackFlat) {
    // The border has points on straight lines, where no triangle may be without area.
    TriangleSoup soup =
        withHoleAt(boxSoup(Vec3::Ones(), 4), [](const Vec3& m) { return m.y() > 0.49; });
    ASSERT_EQ(inspectTriangles(soup).openEdges, 16);
    const HoleFilling done = fillHoles(soup);
    EXPECT_EQ(done.holes, 1);
    EXPECT_EQ(done.triangles, 14);
    const MeshReport report = inspectTriangles(soup);
    EXPECT_TRUE(report.cuttable) << report.problem;
    EXPECT_NEAR(report.volume, 1, 1e-12);
}

TEST(HoleFilling, BothEndsOfATubeAreFilled) {
    TriangleSoup soup =
        withHoleAt(cubeSphereSoup(8, 0.5), [](const Vec3& m) { return std::abs(m.x()) > 0.35; });
    const HoleFilling done = fillHoles(soup);
    EXPECT_EQ(done.holes, 2);
    const MeshReport report = inspectTriangles(soup);
    EXPECT_TRUE(report.cuttable) << report.problem;
    EXPECT_LT(report.volume, 4.0 / 3 * std::numbers::pi * 0.125);
    EXPECT_GT(report.volume, 0.4);
}

TEST(HoleFilling, ASingleMissingTriangleIsPutBack) {
    TriangleSoup soup = weldExactly(icosphereSoup(1));
    const Triangle gone = soup.triangles.back();
    soup.triangles.pop_back();
    EXPECT_EQ(fillHoles(soup).triangles, 1);
    Triangle back = soup.triangles.back();
    while (back[0] != gone[0]) {
        std::rotate(back.begin(), back.begin() + 1, back.end());
    }
    EXPECT_EQ(back, gone);
}

TEST(HoleFilling, HolesThatTouchInAVertexStayOpen) {
    TriangleSoup soup;  // an octahedron without two triangles that share the top alone
    soup.positions = {Vec3(1, 0, 0),  Vec3(0, 0, 1), Vec3(-1, 0, 0),
                      Vec3(0, 0, -1), Vec3(0, 1, 0), Vec3(0, -1, 0)};
    soup.triangles = {{1, 2, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}};
    ASSERT_EQ(inspectTriangles(soup).openEdges, 6);
    EXPECT_EQ(fillHoles(soup).holes, 0);
    EXPECT_EQ(soup.triangles.size(), 6U);
}

}  // namespace
}  // namespace kerf::app

#include "app/import/repair/surface_meshing.h"
#include "sim/repair/soup_editing.h"

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

TriangleSoup openBall() {
    return withHoleAt(icosphereSoup(3), [](const Vec3& m) { return m.y() > 0.2; });
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

TEST(HoleFilling, HolesThatTouchInAVertexAreBothFilled) {
    TriangleSoup soup;  // an octahedron without two triangles that share the top alone
    soup.positions = {Vec3(1, 0, 0),  Vec3(0, 0, 1), Vec3(-1, 0, 0),
                      Vec3(0, 0, -1), Vec3(0, 1, 0), Vec3(0, -1, 0)};
    soup.triangles = {{2, 1, 4}, {0, 3, 4}, {0, 1, 5}, {1, 2, 5}, {2, 3, 5}, {3, 0, 5}};
    ASSERT_EQ(inspectTriangles(soup).openEdges, 6);
    EXPECT_EQ(fillHoles(soup).holes, 2);
    EXPECT_EQ(inspectTriangles(soup).problem, "");
}

TEST(HoleFilling, AHoleOfVeryManyEdgesIsFilledFlat) {
    TriangleSoup soup =
        withHoleAt(boxSoup(Vec3::Ones(), 150), [](const Vec3& m) { return m.y() > 0.499; });
    ASSERT_EQ(inspectTriangles(soup).openEdges, 600);
    EXPECT_EQ(fillHoles(soup).holes, 1);
    const MeshReport report = inspectTriangles(soup);
    EXPECT_TRUE(report.cuttable) << report.problem;
    EXPECT_NEAR(report.volume, 1, 1e-10);
}

TEST(HoleFilling, WhatWasThereStaysBitForBit) {
    const TriangleSoup before = openBall();
    TriangleSoup soup = before;
    fillHoles(soup, true);
    EXPECT_EQ(inspectTriangles(soup).problem, "");
    ASSERT_GT(soup.positions.size(), before.positions.size()) << "not a fan of long triangles";
    soup.positions.resize(before.positions.size());
    soup.triangles.resize(before.triangles.size());
    EXPECT_EQ(soup.positions, before.positions);
    EXPECT_EQ(soup.triangles, before.triangles);
}

TEST(HoleFilling, EdgesOfABorderMayBeMuchLongerThanOthers) {
    TriangleSoup soup = withHoleAt(boxSoup(), [](const Vec3& m) { return m.y() > 0.49; });
    const repair::Side side = repair::openSides(soup).front();
    const Triangle before = soup.triangles[side.triangle()];
    const Vec3 from = soup.positions[before[side.halfEdge % 3]];
    const Vec3 way = soup.positions[before[(side.halfEdge + 1) % 3]] - from;
    Triangle rest = before;  // of one triangle becomes a fan with many short edges
    for (int i = 1; i < 12; ++i) {
        Triangle slice = rest;
        slice[(side.halfEdge + 1) % 3] = static_cast<int>(soup.positions.size());
        rest[side.halfEdge % 3] = static_cast<int>(soup.positions.size());
        soup.positions.emplace_back(from + i / 12.0 * way);
        soup.triangles.push_back(slice);
    }
    soup.triangles[side.triangle()] = rest;
    ASSERT_EQ(inspectTriangles(soup).openEdges, 15);
    EXPECT_EQ(fillHoles(soup, true).holes, 1);
    EXPECT_EQ(inspectTriangles(soup).problem, "");
}

TEST(HoleFilling, AFineHoleIsEvenedBesideAWideOne) {
    const TriangleSoup box =
        withHoleAt(boxSoup(Vec3::Constant(20)), [](const Vec3& m) { return m.y() > 9; });
    TriangleSoup soup = joined(box, openBall(), Vec3(0, 50, 0));
    const std::size_t before = soup.positions.size();
    EXPECT_EQ(fillHoles(soup, true).holes, 2);
    EXPECT_EQ(inspectTriangles(soup).problem, "");
    EXPECT_GT(soup.positions.size(), before + 10);
}

TEST(HoleFilling, NothingIsEvenedWhereAHoleStaysOpen) {
    // On the torus by Moebius each two of seven vertices share an edge, so that without one of them
    // no diagonal is left for the hole.
    TriangleSoup torus;
    for (int i = 0; i < 7; ++i) {
        torus.positions.emplace_back(20 * std::cos(i), 20 * std::sin(i), i);
        torus.triangles.push_back({i, (i + 1) % 7, (i + 3) % 7});
        torus.triangles.push_back({i, (i + 3) % 7, (i + 2) % 7});
    }
    ASSERT_TRUE(inspectTriangles(torus).closed);
    std::erase_if(torus.triangles, [](const Triangle& t) { return std::ranges::count(t, 6) > 0; });
    torus.positions.pop_back();
    TriangleSoup soup = joined(torus, openBall(), Vec3(0, 50, 0));
    const std::size_t before = soup.positions.size();
    EXPECT_EQ(fillHoles(soup, true).holes, 1);
    EXPECT_EQ(inspectTriangles(soup).openEdges, 6);
    EXPECT_EQ(soup.positions.size(), before);
}

TEST(HoleFilling, WhatIsNotManifoldStaysOpen) {
    TriangleSoup soup = withHoleAt(boxSoup(), [](const Vec3& m) { return m.y() > 0.49; });
    soup.triangles.push_back(soup.triangles.front());
    EXPECT_EQ(fillHoles(soup).holes, 0);
}

}  // namespace
}  // namespace kerf::app

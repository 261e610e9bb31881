#include "sim/repair/double_triangles.h"

#include <gtest/gtest.h>

#include "sim/repair/soup_inspection.h"
#include "sim/repair/soup_repair.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

using repair::dropDoubles;

Triangle backOf(const Triangle& t) {
    return {t[0], t[2], t[1]};
}

/// Doubles with the other side of all triangles whose corners lie above `z`.
TriangleSoup doubledAbove(TriangleSoup soup, double z) {
    const std::vector<Triangle> before = soup.triangles;
    for (const Triangle& t : before) {
        if (std::ranges::all_of(t, [&](int v) { return soup.positions[v].z() > z; })) {
            soup.triangles.push_back(backOf(t));
        }
    }
    return soup;
}

TEST(Doubles, OfADoubleSidedPartOneSideStays) {
    const double volume = inspectTriangles(test::icosphereSoup(3)).volume;
    for (const double z : {0.4, 0.25, 0.0, -0.3, -1.0}) {
        SCOPED_TRACE(z);
        TriangleSoup ball = doubledAbove(test::icosphereSoup(3), z);
        repair::repairSoup(ball);
        const MeshReport report = inspectTriangles(ball);
        EXPECT_TRUE(report.cuttable) << report.problem;
        EXPECT_EQ(report.triangles, 1280);
        EXPECT_NEAR(report.volume, volume, 1e-12);
    }
}

/// A unit cube whose opposite faces have the same diagonal.
TriangleSoup cell() {
    TriangleSoup cube;
    for (int i = 0; i < 8; ++i) {
        cube.positions.emplace_back(i % 2, i / 2 % 2, i / 4);
    }
    for (int axis = 0; axis < 3; ++axis) {
        const int u = 1 << (axis + 1) % 3;
        const int v = 1 << (axis + 2) % 3;
        const int high = 1 << axis;
        cube.triangles.push_back({high, high + u, high + u + v});
        cube.triangles.push_back({high, high + u + v, high + v});
        cube.triangles.push_back({0, u + v, u});
        cube.triangles.push_back({0, v, u + v});
    }
    return cube;
}

/// Cubes side by side, `n` along each axis, with welded vertices.
TriangleSoup cubesInABlock(int n) {
    TriangleSoup all;
    for (int i = 0; i < n * n * n; ++i) {
        const Eigen::Vector3i place(i % n, i / n % n, i / (n * n));
        all = test::joined(all, cell(), place.cast<double>());
    }
    return weldExactly(all);
}

TEST(Doubles, OfWallsBetweenCubesNoneStays) {
    for (const int n : {2, 3, 4}) {
        TriangleSoup cubes = cubesInABlock(n);
        EXPECT_EQ(dropDoubles(cubes), 3 * (n - 1) * n * n * 4);
        const MeshReport report = inspectTriangles(cubes);
        EXPECT_TRUE(report.cuttable) << report.problem;
        EXPECT_NEAR(report.volume, n * n * n, 1e-12);
    }
}

TEST(Doubles, OfAFaceThatTwoSolidsHaveBothStay) {
    TriangleSoup longer = test::boxSoup(Vec3(2, 1, 1));
    TriangleSoup both = weldExactly(test::joined(longer, test::boxSoup(), Vec3(-0.5, 0, 0)));
    EXPECT_EQ(dropDoubles(both), 0);
    EXPECT_EQ(both.triangles.size(), 24u);
}

TEST(Doubles, OfAModelThatIsThereTwiceOneStays) {
    TriangleSoup ball = test::icosphereSoup(2);
    const std::vector<Triangle> before = ball.triangles;
    ball.triangles.insert(ball.triangles.end(), before.begin(), before.end());
    EXPECT_EQ(dropDoubles(ball), 320);
    EXPECT_EQ(ball.triangles, before);
}

TEST(Doubles, OfASolidThatIsThereOnceForEachSideAndHasANeighbourOneStays) {
    const TriangleSoup both = test::joined(cell(), test::turned(cell()), Vec3::Zero());
    TriangleSoup three = weldExactly(test::joined(both, cell(), Vec3(1, 0, 0)));
    repair::repairSoup(three);
    const MeshReport report = inspectTriangles(three);
    EXPECT_TRUE(report.cuttable) << report.problem;
    EXPECT_NEAR(report.volume, 2, 0.01);
}

TEST(Doubles, OfAFlapNoneStays) {
    TriangleSoup box = test::boxSoup();
    const Triangle flap{0, 1, static_cast<int>(box.positions.size())};
    box.positions.emplace_back(2, 2, 2);
    box.triangles.push_back(flap);
    box.triangles.push_back(backOf(flap));
    EXPECT_EQ(dropDoubles(box), 2);
    EXPECT_TRUE(inspectTriangles(box).cuttable);
}

}  // namespace
}  // namespace kerf

#include "sim/mesh/triangle.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace kerf {
namespace {

const Corners kRightAngled{Vec3(1, 1, 1), Vec3(4, 1, 1), Vec3(1, 5, 1)};

TEST(Triangle, NormalSeesItsCornersGoCounterClockwise) {
    const auto& [a, b, c] = kRightAngled;
    EXPECT_EQ(areaNormal(kRightAngled), Vec3(0, 0, 12));
    EXPECT_EQ(unitNormal(a, b, c), Vec3::UnitZ());
    EXPECT_EQ(unitNormal(a, c, b), -Vec3::UnitZ());
    EXPECT_EQ(unitNormal(a, b, a), Vec3::Zero()) << "no area";
}

TEST(Triangle, AreaIsHalfTheLengthOfItsNormal) {
    EXPECT_EQ(triangleArea(kRightAngled), 6);
}

TEST(Triangle, LongestEdgeIsTheHypotenuse) {
    EXPECT_EQ(longestEdgeSquare(kRightAngled), 25);
    EXPECT_EQ(longestEdge(kRightAngled), 5);
}

TEST(Triangle, TetrahedraSumUpToTheVolumeWhereverTheApexLies) {
    const SurfaceMesh mesh = test::box(Vec3(2, 3, 4));
    for (const Vec3& apex : {Vec3(0, 0, 0), Vec3(5, -1, 2)}) {
        double volume = 0;
        for (int t = 0; t < mesh.triangleSlots(); ++t) {
            const auto [a, b, c] = cornersOf(mesh, t);
            volume += tetrahedronVolume(a - apex, b - apex, c - apex);
        }
        EXPECT_NEAR(volume, 24, 1e-12);
    }
}

TEST(Triangle, CornersAreCurrentOrAtRest) {
    SurfaceMesh mesh = test::box(Vec3::Ones());
    const Corners rest = restCornersOf(mesh, 0);
    EXPECT_EQ(cornersOf(mesh, 0), rest);
    mesh.setPosition(mesh.triangle(0)[1], Vec3(7, 8, 9));
    EXPECT_EQ(cornersOf(mesh, 0)[1], Vec3(7, 8, 9));
    EXPECT_EQ(restCornersOf(mesh, 0), rest);
}

}  // namespace
}  // namespace kerf

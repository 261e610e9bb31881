#include "sim/mesh/triangle_quality.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace kerf {
namespace {

TEST(TriangleQuality, ANeedleIsLowerThanATenthOfItsLongestEdge) {
    EXPECT_FALSE(isNeedle({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 0.11, 0)}));
    EXPECT_TRUE(isNeedle({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 0.09, 0)}));
    EXPECT_TRUE(isNeedle({Vec3(0, 0, 0), Vec3(1000, 0, 0), Vec3(1, 90, 0)}));
    EXPECT_FALSE(isNeedle({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 0, 0)})) << "has no area";
}

TEST(TriangleQuality, FiguresAreThoseOfTheBox) {
    const TriangleFigures box = figuresOf(test::boxSoup(Vec3(1, 20, 1)));
    EXPECT_EQ(box.triangles, 12);
    EXPECT_EQ(box.needles, 8);
    EXPECT_NEAR(box.area, 82, 1e-9);
    EXPECT_NEAR(box.shortestEdge, 1, 1e-12);
    EXPECT_NEAR(box.longestEdge, std::sqrt(401), 1e-12);
    EXPECT_EQ(figuresOf({}).meanEdge(), 0);
}

TEST(TriangleQuality, EvenEdgesAreTheMeanOrAtMostFourTimesTheTriangles) {
    const TriangleFigures ball = figuresOf(test::icosphereSoup(3));
    EXPECT_NEAR(evenEdge(ball), ball.meanEdge(), 0.02 * ball.meanEdge());
    EXPECT_NEAR(trianglesOf(ball, ball.meanEdge()), ball.triangles, 0.05 * ball.triangles);
    const TriangleFigures mixed = figuresOf(test::joined(
        test::icosphereSoup(4, 0.01), test::boxSoup(Vec3::Constant(10)), Vec3::Zero()));
    EXPECT_GT(evenEdge(mixed), 2 * mixed.meanEdge());
    EXPECT_NEAR(trianglesOf(mixed, evenEdge(mixed)), 4.0 * mixed.triangles, 1);
    const TriangleFigures needles = figuresOf(test::boxSoup(Vec3(1, 20, 1)));
    EXPECT_LT(evenEdge(needles), 0.5 * needles.meanEdge());
}

TEST(TriangleQuality, OfACoarseSkinShorterEdgesAreProposed) {
    const TriangleFigures cube = figuresOf(test::boxSoup());
    const double diagonal = std::sqrt(3);
    EXPECT_TRUE(isCoarse(cube, diagonal));
    EXPECT_NEAR(proposedEdge(cube, diagonal), diagonal / 25, 1e-12);
    const TriangleFigures fine = figuresOf(test::boxSoup(Vec3::Ones(), 12));
    EXPECT_FALSE(isCoarse(fine, diagonal));
    EXPECT_EQ(proposedEdge(fine, diagonal), evenEdge(fine));
    EXPECT_FALSE(isCoarse(figuresOf({}), 0));
    EXPECT_FALSE(isCoarse(figuresOf(test::builtinSoup("sphere768")), diagonal));
    const TriangleFigures uneven = figuresOf(
        test::joined(test::icosphereSoup(4, 0.1), test::boxSoup(Vec3::Ones()), Vec3(1, 0, 0)));
    EXPECT_TRUE(isCoarse(uneven, 2.2));
    EXPECT_LE(proposedEdge(uneven, 2.2), 2.2 / 25);
}

TEST(ShapeFigures, OfTwoSurfacesAreThoseOfAllTriangles) {
    const Corners even{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, std::sqrt(0.75), 0)};
    const Corners flat{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 0.01, 0)};
    ShapeFigures all, first, second;
    for (const Corners& corners : {even, flat}) {
        all.add(corners);
    }
    first.add(even);
    second.add(flat);
    for (ShapeFigures sum : {first, second}) {
        sum.add(sum.slivers > 0 ? first : second);
        EXPECT_EQ(sum.triangles, 2);
        EXPECT_EQ(sum.slivers, 1);
        EXPECT_EQ(sum.bareSlivers, 0);
        EXPECT_EQ(sum.worstAngle, all.worstAngle);
        EXPECT_NEAR(sum.angleSum, all.angleSum, 1e-9);
    }
    EXPECT_NEAR(first.worstAngle, 60, 1e-9);
    EXPECT_NEAR(second.worstAngle, 180 / 3.14159265 * std::atan(0.02), 1e-6);
}

}  // namespace
}  // namespace kerf

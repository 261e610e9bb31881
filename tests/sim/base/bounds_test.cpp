#include <gtest/gtest.h>

#include "sim/base/math.h"

namespace kerf {
namespace {

Bounds cube(double center, double half) {
    Bounds bounds;
    bounds.add(Vec3::Constant(center));
    bounds.widen(half);
    return bounds;
}

TEST(Bounds, EmptyOnesOverlapNothing) {
    EXPECT_TRUE(Bounds{}.empty());
    EXPECT_FALSE(Bounds{}.overlaps(cube(0, 1)));
    EXPECT_EQ(Bounds{}.diagonal(), 0);
}

TEST(Bounds, OverlapWhereTheyTouch) {
    EXPECT_TRUE(cube(0, 1).overlaps(cube(2, 1)));
    EXPECT_FALSE(cube(0, 1).overlaps(cube(2.5, 1)));
}

TEST(Bounds, TakeInOthers) {
    Bounds both = cube(0, 1);
    both.add(cube(4, 1));
    EXPECT_EQ(both.low, Vec3::Constant(-1));
    EXPECT_EQ(both.high, Vec3::Constant(5));
}

TEST(Bounds, CornersSpanTheBox) {
    const Bounds box = cube(1, 2);
    EXPECT_EQ(box.corner(0), box.low);
    EXPECT_EQ(box.corner(7), box.high);
    EXPECT_EQ(box.corner(2), Vec3(-1, 3, -1));
}

}  // namespace
}  // namespace kerf

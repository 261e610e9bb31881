#include "sim/repair/surface_contact.h"

#include <gtest/gtest.h>

namespace kerf::repair {
namespace {

const Corners kFloor{Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(0, 1, 0)};

TEST(CrossingDepth, OfACornerThroughAFaceIsHowFarItReaches) {
    const Corners pierces{Vec3(0, 0, -0.01), Vec3(-0.1, 0, 1), Vec3(0.1, 0, 1)};
    EXPECT_NEAR(crossingDepth(kFloor, pierces), 0.01, 1e-12);
    EXPECT_NEAR(crossingDepth(pierces, kFloor), 0.01, 1e-12);
}

TEST(CrossingDepth, OfTwoEdgesIsHowFarTheyPassEachOther) {
    const Corners upright{Vec3(-1, -1.02, -1), Vec3(1, -1.02, -1), Vec3(0, -0.96, 1)};
    const double depth = crossingDepth(kFloor, upright);
    EXPECT_GT(depth, 0);
    EXPECT_LT(depth, 0.02);
}

// One is bent away outside of the other: what lies there does not count.
TEST(CrossingDepth, OfNearlyParallelOnesIsThatWhereTheyLieOverEachOther) {
    const Corners beside{Vec3(-1, 0, 1e-9), Vec3(3, 0.1, -0.4), Vec3(3, -0.1, -0.4)};
    const Corners strip{Vec3(-3, -1, 0), Vec3(-0.999999, 0, 0), Vec3(-3, 1, 0)};
    EXPECT_LT(crossingDepth(strip, beside), 1e-5);
}

TEST(CrossingDepth, InOnePlaneIsZero) {
    EXPECT_EQ(crossingDepth(kFloor, kFloor), 0);
}

}  // namespace
}  // namespace kerf::repair

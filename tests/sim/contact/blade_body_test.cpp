#include "sim/contact/blade_body.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

const Vec3 kHalf(0, 0, 0.5);

Blade bladeAt(const Vec3& middle) {
    return {middle - kHalf, middle + kHalf};
}

BladeTrail led(const std::vector<Vec3>& places, double width = 0.2) {
    BladeTrail trail{bladeAt(places.front())};
    for (std::size_t i = 1; i < places.size(); ++i) {
        trail = ledTo(trail, bladeAt(places[i]), width);
    }
    return trail;
}

TEST(BladeTrail, TheBodyTrailsTheEdgeAndComesOutOfWhereItWasPlaced) {
    EXPECT_TRUE(led({{0, 0, 0}}).back.isZero());
    const BladeTrail trail = led({{0, 0, 0}, {0.05, 0, 0}, {0.1, 0, 0.3}});
    EXPECT_LT((trail.back - Vec3(-1, 0, 0)).norm(), 1e-12) << "not along the edge";
    EXPECT_NEAR(trail.widthOf({0.2, 0.01}), 0.1, 1e-12);
    EXPECT_NEAR(led({{0, 0, 0}, {0.5, 0, 0}}).widthOf({0.2, 0.01}), 0.2, 1e-12);
}

TEST(BladeTrail, DrawnBackOrAsideItKeepsItsDirection) {
    for (const Vec3& to : {Vec3(0.1, 0, 0), Vec3(0.4, 0.3, 0), Vec3(0.4, -0.3, 0)}) {
        const BladeTrail trail = led({{0, 0, 0}, {0.4, 0, 0}, to});
        EXPECT_LT((trail.back - Vec3(-1, 0, 0)).norm(), 1e-12);
        EXPECT_NEAR(trail.farthest, 0.4, 1e-12);
        EXPECT_NEAR(trail.way, to.x(), 1e-12);
    }
}

TEST(BladeTrail, AFirstTouchAsideDoesNotTurnItForGood) {
    const BladeTrail trail = led({{0, 0, 0}, {0, 0.001, 0}, {0.1, 0.001, 0}, {0.4, 0.001, 0}});
    EXPECT_LT((trail.back - Vec3(-1, 0, 0)).norm(), 0.01);
    EXPECT_NEAR(trail.farthest, 0.4, 0.002);
}

TEST(BladeTrail, ItFollowsACurve) {
    std::vector<Vec3> places;
    for (int i = 0; i <= 100; ++i) {
        const double angle = 0.01 * i * std::numbers::pi / 2;
        places.emplace_back(std::sin(angle), std::cos(angle), 0);
    }
    const BladeTrail trail = led(places);
    // A point towed at 0.2 on a circle of radius 1 lies on one of radius sqrt(0.96).
    EXPECT_NEAR((places.back() + 0.2 * trail.back).norm(), std::sqrt(0.96), 0.01);
    EXPECT_GT(trail.back.y(), 0.9);
}

TEST(BladeTrail, JitterOfTheHandDoesNotSwingIt) {
    std::vector<Vec3> places{{0, 0, 0}};
    for (int i = 1; i < 60; ++i) {
        places.emplace_back(0.01 * i, i % 2 == 0 ? 0.002 : -0.002, 0);
    }
    EXPECT_LT((led(places).back - Vec3(-1, 0, 0)).norm(), 0.05);
}

TEST(BladeMotion, GoesEvenlyThroughAllPosesOfAStep) {
    std::vector<BladeTrail> trails{led({{-0.5, 0, 0}, {0, 0, 0}})};
    trails.push_back(ledTo(trails.back(), bladeAt({0.1, 0, 0}), 0.2));
    trails.push_back(ledTo(trails.back(), bladeAt({0.4, 0, 0}), 0.2));
    const BladeMotion motion = motionOf(trails, {0.2, 0.01}, 0.03, 0.05, 4);
    ASSERT_EQ(motion.frames.size(), 5U);
    const std::array expected{0.0, 0.05, 0.1, 0.25, 0.4};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(motion.frames[i].origin.x(), expected[i], 1e-12);
        EXPECT_NEAR(motion.frames[i].axes.determinant(), 1, 1e-12);
    }
    EXPECT_EQ(motion.halfAt(0.02), 0);
    EXPECT_NEAR(motion.halfAt(0.06), 0.0025, 1e-12);
    EXPECT_NEAR(motion.halfAt(0.15), 0.005, 1e-12);
    const Bounds box = motion.bounds();
    EXPECT_LT((box.low - Vec3(-0.2, -0.005, -0.5)).norm(), 1e-12);
    EXPECT_LT((box.high - Vec3(0.37, 0.005, 0.5)).norm(), 1e-12);
}

}  // namespace
}  // namespace kerf

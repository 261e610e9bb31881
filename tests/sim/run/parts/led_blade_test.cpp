#include "sim/run/parts/led_blade.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

constexpr double kLag = 0.2;
constexpr double kWidth = 5;  // wider than all ways here

/// The middle of the cutting edge, once a blade along z was led through these places.
Vec3 edgeAfter(const std::vector<Vec3>& places, double lag = kLag) {
    LedBlade blade;
    for (const Vec3& place : places) {
        const Blade to{place - Vec3(0, 0, 0.5), place + Vec3(0, 0, 0.5)};
        blade.moveTo(to, kWidth, blade.edgeAt(to, lag));
    }
    return 0.5 * (blade.edge().a + blade.edge().b);
}

TEST(LedBlade, ItsEdgeStaysUntilTheLagIsTakenUpAndThenFollows) {
    EXPECT_LT(edgeAfter({{0, 0, 0}, {0.15, 0, 0}}).norm(), 1e-12);
    EXPECT_LT((edgeAfter({{0, 0, 0}, {0.15, 0, 0}, {0.5, 0, 0}}) - Vec3(0.3, 0, 0)).norm(), 1e-12);
    EXPECT_EQ(edgeAfter({{0, 0, 0}, {0.5, 0, 0}}, 0), Vec3(0.5, 0, 0));
}

TEST(LedBlade, ItsEdgeMovesAlongItselfWithoutLag) {
    const Vec3 edge = edgeAfter({{0, 0, 0}, {0.5, 0, 0}, {0.5, 0, -0.4}});
    EXPECT_LT((edge - Vec3(0.3, 0, -0.4)).norm(), 1e-12);
}

TEST(LedBlade, ItsEdgeFollowsWhereverTheFirstTouchWent) {
    for (const Vec3& first : {Vec3(0, 0.001, 0), Vec3(0, -0.001, 0), Vec3(-0.001, 0, 0)}) {
        const Vec3 edge = edgeAfter({{0, 0, 0}, first, first + Vec3(0.3, 0, 0), {0.9, 0, 0}});
        EXPECT_LT((edge - Vec3(0.7, 0, 0)).norm(), 0.002) << first.transpose();
    }
}

TEST(LedBlade, ItsEdgeFollowsACircleThatIsSmallerThanItsBody) {
    std::vector<Vec3> places;
    for (int i = 0; i <= 400; ++i) {
        const double turn = 0.01 * i * std::numbers::pi;
        places.emplace_back(std::cos(turn), std::sin(turn), 0);
    }
    EXPECT_NEAR(edgeAfter(places).norm(), std::sqrt(1 - kLag * kLag), 0.005);
}

TEST(LedBlade, ItsEdgeStaysWhileTheBladeTurnsWithinTheLag) {
    const Blade upright{{0, 0, -0.5}, {0, 0, 0.5}};
    const Blade turned{{0.09, 0, -0.5}, {-0.09, 0, 0.5}};
    LedBlade blade;
    blade.moveTo(upright, kWidth, upright);
    const Blade edge = blade.edgeAt(turned, kLag);
    EXPECT_LT(edge.a.head<2>().norm() + edge.b.head<2>().norm(), 0.01);
}

TEST(LedBlade, DrawnBackItsEdgeStaysUntilTheLagIsTakenUpAgain) {
    EXPECT_LT((edgeAfter({{0, 0, 0}, {0.9, 0, 0}, {0.6, 0, 0}}) - Vec3(0.7, 0, 0)).norm(), 1e-12);
    EXPECT_LT((edgeAfter({{0, 0, 0}, {0.9, 0, 0}, {0.2, 0, 0}}) - Vec3(0.4, 0, 0)).norm(), 1e-12);
}

}  // namespace
}  // namespace kerf

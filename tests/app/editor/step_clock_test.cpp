// Steps that are due by the clock.
#include "app/editor/steps/step_clock.h"

#include <gtest/gtest.h>

namespace kerf::app {
namespace {

constexpr double kTimeStep = 0.005;
constexpr double kPicture = 0.011;  // [s]

TEST(StepClock, TimeThatStoodIsNotCaughtUpWith) {
    StepClock clock(true, 1);
    clock.elapse(10);
    clock.stop();
    clock.elapse(kPicture);
    clock.passTime(kTimeStep);
    EXPECT_EQ(clock.due(), 2);
}

TEST(StepClock, MoreThanATenthOfASecondIsNotCaughtUpWith) {
    for (const double step : {0.001, kTimeStep, 0.02}) {
        StepClock clock(true, 1);
        clock.elapse(10);
        clock.passTime(step);
        EXPECT_NEAR(clock.due() * step, 0.1, 1.01 * step)
            << "a small step is no reason to fall behind";
    }
}

TEST(StepClock, FasterTimeIsDueSooner) {
    StepClock clock(true, 1);
    clock.setSpeed(4);
    clock.elapse(kPicture);
    clock.passTime(kTimeStep);
    EXPECT_EQ(clock.due(), 8);
}

TEST(StepClock, APauseIsNoFrameTime) {
    StepClock clock(true, 1);
    EXPECT_TRUE(clock.starts());
    EXPECT_EQ(clock.measure().all, 0);
    clock.elapse(kPicture);
    EXPECT_EQ(clock.measure().all, kPicture);
    clock.elapse(1);
    clock.stop();
    clock.elapse(kPicture);
    EXPECT_EQ(clock.measure().all, 0);
}

}  // namespace
}  // namespace kerf::app

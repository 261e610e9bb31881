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
    EXPECT_EQ(clock.takeDue(kTimeStep), 2);
}

TEST(StepClock, WhatASlowPictureLeavesBehindIsNotCaughtUpWith) {
    StepClock clock(true, 1);
    clock.elapse(10);
    EXPECT_EQ(clock.takeDue(kTimeStep), 4);
    clock.elapse(kPicture);
    EXPECT_LE(clock.takeDue(kTimeStep), 2);
}

TEST(StepClock, APauseIsNoFrameTime) {
    StepClock clock(true, 1);
    EXPECT_FALSE(clock.measure());
    clock.elapse(kPicture);
    EXPECT_EQ(clock.measure(), kPicture);
    clock.elapse(1);
    clock.stop();
    clock.elapse(kPicture);
    EXPECT_FALSE(clock.measure());
}

}  // namespace
}  // namespace kerf::app

// A body that lies still and is not solved until something is done to it.
#include <gtest/gtest.h>

#include "gpu/traffic.h"
#include "sim/mesh/invariants.h"
#include "tests/support/shapes.h"
#include "tests/support/simulation_fixture.h"

namespace kerf {
namespace {

constexpr int kMostSteps = 1600;  // of 0.005 s

class SleepTest : public test::SimulationTest {
  protected:
    static Params sleeping() {
        Params params;
        params.sleeps = 1;
        params.airDrag = 4;
        params.floor = -0.51;
        return params;
    }
    void start(const Params& params) { simulation.emplace(test::cubeSphere(4, 0.5), params); }
    /// What one step asks of the driver.
    gpu::Traffic step() {
        const gpu::Traffic before = gpu::traffic();
        simulation->step();
        return gpu::traffic() - before;
    }
    bool sleepsNow() { return step().dispatches == 0; }
    /// Returns after how many steps it sleeps; kMostSteps where it does not.
    int stepsUntilItSleeps() {
        int steps = 0;
        while (steps < kMostSteps && !sleepsNow()) {
            ++steps;
        }
        return steps;
    }
    void fallAsleep() {
        start(sleeping());
        ASSERT_LT(stepsUntilItSleeps(), kMostSteps);
    }
};

TEST_F(SleepTest, AtRestAStepAsksNothingOfTheDriver) {
    fallAsleep();
    const std::string asleep = simulation->stateHash();
    const double time = simulation->report().time;
    for (int i = 0; i < 50; ++i) {
        const gpu::Traffic traffic = step();
        EXPECT_EQ(traffic.dispatches, 0u);
        EXPECT_EQ(traffic.waits, 0u);
        EXPECT_EQ(traffic.reads, 0u);
    }
    EXPECT_EQ(simulation->stateHash(), asleep);
    EXPECT_GT(simulation->report().time, time) << "time goes on";
    EXPECT_NEAR(simulation->report().volumeRatio, 1, 0.01);
    EXPECT_EQ(simulation->report().pieces, 1);
}

TEST_F(SleepTest, WithoutTheParameterItIsSolvedInEveryStep) {
    Params params = sleeping();
    params.sleeps = 0;
    start(params);
    EXPECT_EQ(stepsUntilItSleeps(), kMostSteps);
}

TEST_F(SleepTest, WhatFallsIsAwake) {
    Params params = sleeping();
    params.floor.reset();
    start(params);
    EXPECT_EQ(stepsUntilItSleeps(), kMostSteps);
}

TEST_F(SleepTest, AParameterWakesIt) {
    fallAsleep();
    simulation->execute(SetParam{"gravity", Vec3(0, 3, 0)});
    EXPECT_FALSE(sleepsNow());
    const double before = simulation->bounds().high.y();
    run(20);
    EXPECT_GT(simulation->bounds().high.y(), before + 0.02) << "it rises";
}

TEST_F(SleepTest, AHandWakesItAndKeepsItAwake) {
    fallAsleep();
    const Vec3 top(0, simulation->bounds().high.y(), 0);
    ASSERT_EQ(simulation->execute(Grab{.hand = 1, .at = top, .radius = 0.3}), "");
    for (int i = 0; i < 300; ++i) {
        EXPECT_FALSE(sleepsNow());
    }
    simulation->execute(Release{1});
    EXPECT_FALSE(sleepsNow());
    EXPECT_LT(stepsUntilItSleeps(), kMostSteps);
}

TEST_F(SleepTest, ABladeCutsWhatSleeps) {
    fallAsleep();
    for (int i = 0; i <= 30; ++i) {
        const double y = 0.7 - 1.5 * i / 30;
        simulation->execute(MoveBlade{{{0.03, y, -1}, {0.03, y, 1}}});
        simulation->step();
    }
    simulation->execute(LiftBlade{});
    simulation->step();
    EXPECT_EQ(simulation->pieces().pieces.size(), 2u);
    EXPECT_TRUE(simulation->report().closed);
}

/// Moments and undo go back to a body that is as far from sleep as it was.
TEST_F(SleepTest, TheSameStepsAgainEndInTheSameBits) {
    start(sleeping());
    run(100);
    const Moment moment = simulation->moment();
    const int first = stepsUntilItSleeps();
    const std::string hash = simulation->stateHash();
    run(30);
    simulation->goTo(moment);
    EXPECT_EQ(stepsUntilItSleeps(), first);
    EXPECT_EQ(simulation->stateHash(), hash);
}

}  // namespace
}  // namespace kerf

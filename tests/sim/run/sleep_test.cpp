// A body that lies still and is not solved until something is done to it.
#include "gpu/traffic.h"

namespace kerf {
namespace {

constexpr int kMostSteps = 1600;  // of 0.005 s

class SleepTest : public SimulationFixture {
  protected:
    static Params sleeping() {
        Params params;
        params.sleeps = 1;
        params.airDrag = 4;
        params.floor = -0.51;
        return params;
    }
    void start(const Params& params) { simulation.emplace(cubeSphere(4, 0.5), params); }
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
    makeStroke(*simulation, {{0.03, 0.7, -1}, {0.03, 0.7, 1}}, {{0.03, -0.8, -1}, {0.03, -0.8, 1}},
               30);
    EXPECT_EQ(simulation->pieces().pieces.size(), 2u);
    EXPECT_TRUE(simulation->report().closed);
}

/// Moments and undo go back to a body that is as far from sleep as it was.
TEST_F(SleepTest, TheSameStepsAgainEndInTheSameBits) {
    start(sleeping());
    run(100);
    const Checkpoint then = simulation->checkpoint();
    const int first = stepsUntilItSleeps();
    const std::string hash = simulation->stateHash();
    run(30);
    simulation->goTo(then);
    EXPECT_EQ(stepsUntilItSleeps(), first);
    EXPECT_EQ(simulation->stateHash(), hash);
}

// Steps while time stands: the blade alone acts.

Params falling() {
    Params params;
    params.iterations = 4;
    params.floor = -0.8;
    return params;
}

class TimeStandsTest : public SimulationFixture {
  protected:
    void SetUp() override {
        SimulationFixture::SetUp();
        simulation.emplace(cubeSphere(6, 0.5), falling());
    }
    void letTimeRun(bool runs) { EXPECT_EQ(simulation->execute(SetTime{runs}), ""); }
    void cutThrough(double x) {
        makeStroke(*simulation, {{x, 0.7, -1}, {x, 0.7, 1}}, {{x, -1.3, -1}, {x, -1.3, 1}}, 20);
    }
    double time() const { return simulation->report().time; }
};

TEST_F(TimeStandsTest, ABodyInFlightStaysAndThenFliesOnToTheBit) {
    run(20);
    const std::string whereItWas = simulation->stateHash();
    run(20);
    const std::string later = simulation->stateHash();
    simulation->reset();
    run(20);
    letTimeRun(false);
    const double then = time();
    run(7);
    EXPECT_EQ(simulation->stateHash(), whereItWas);
    EXPECT_EQ(time(), then);
    EXPECT_EQ(simulation->stepCount(), 27);
    letTimeRun(true);
    run(20);
    EXPECT_EQ(simulation->stateHash(), later);
    EXPECT_GT(time(), then);
}

TEST_F(TimeStandsTest, ABladeCutsTheBodyWhereItLies) {
    run(10);
    const SurfaceMesh before = simulation->mesh();
    letTimeRun(false);
    cutThrough(0.02);
    EXPECT_EQ(simulation->report().pieces, 2);
    EXPECT_TRUE(simulation->report().closed);
    EXPECT_EQ(simulation->report().times.deform, 0);
    const SurfaceMesh& after = simulation->mesh();
    int same = 0;
    for (int v = 0; v < before.vertexCount(); ++v) {
        same += after.position(v) == before.position(v) ? 1 : 0;
    }
    EXPECT_GT(same, 0.8 * before.vertexCount()) << "only beside the cut vertices are moved";
    EXPECT_NEAR(simulation->report().volumeRatio, 1, 0.02);
    const double high = simulation->bounds().center().y();
    letTimeRun(true);
    run(40);
    EXPECT_LT(simulation->bounds().center().y(), high - 0.01) << "the halves fall";
    EXPECT_EQ(simulation->report().pieces, 2);
    EXPECT_TRUE(simulation->report().closed);
}

TEST_F(TimeStandsTest, AnUndoTakesBackWhatWasCutThen) {
    simulation->setUndoBudget(std::size_t{1} << 30);
    run(10);
    const std::string whole = simulation->stateHash();
    letTimeRun(false);
    cutThrough(0.02);
    EXPECT_EQ(simulation->execute(Undo{}), "");
    EXPECT_EQ(simulation->stateHash(), whole);
    EXPECT_FALSE(simulation->timeRuns());
}

TEST_F(TimeStandsTest, AMomentKnowsThatItStoodAndAResetLetsItRun) {
    letTimeRun(false);
    const Checkpoint then = simulation->checkpoint();
    letTimeRun(true);
    run(3);
    simulation->goTo(then);
    EXPECT_FALSE(simulation->timeRuns());
    simulation->reset();
    EXPECT_TRUE(simulation->timeRuns());
}

// Iterations that the simulation chooses before each step.

/// The iterations of steps, and what these led to.
struct Course {
    std::vector<int> iterations;
    std::string hash;
    bool operator==(const Course&) const = default;
};

class AutoIterationsTest : public SimulationFixture {
  protected:
    static Params autoParams() {
        Params params = ofNewScene(Params{});
        params.sleeps = 0;
        params.floor = -0.6;
        return params;
    }
    void start(const Params& params) { simulation.emplace(cubeSphere(4, 0.5), params); }
    int step() { return simulation->step().iterations; }
    Course play(int steps) {
        Course course;
        for (int i = 0; i < steps; ++i) {
            course.iterations.push_back(step());
        }
        course.hash = simulation->stateHash();
        return course;
    }
    void set(const char* name, const ParamValue& value) {
        ASSERT_EQ(simulation->execute(SetParam{name, value}), "") << name;
    }
    /// A fall, a cut and other parameters, so that the number changes by the state and by these.
    Course playScene() {
        Course course = play(20);
        const auto go = [&](int steps) {
            const Course next = play(steps);
            course.iterations.insert(course.iterations.end(), next.iterations.begin(),
                                     next.iterations.end());
            course.hash += next.hash;
        };
        for (int i = 0; i <= 20; ++i) {
            const double y = 0.7 - 1.6 * i / 20;
            simulation->execute(MoveBlade{{{0.03, y, -1}, {0.03, y, 1}}});
            go(1);
        }
        simulation->execute(LiftBlade{});
        go(5);
        set("youngs_modulus", 2e6);
        go(5);
        simulation->execute(SetTime{false});
        go(2);
        simulation->execute(SetTime{true});
        simulation->execute(Undo{});
        go(5);
        simulation->execute(Undo{});
        go(10);
        return course;
    }
};

TEST_F(AutoIterationsTest, AreMoreWhereSomethingFastMeetsAnything) {
    Params params = autoParams();
    params.floor = -20;
    start(params);
    const int slow = step();
    set("gravity", Vec3(0, -60, 0));
    run(60);
    EXPECT_EQ(step(), slow) << "in free fall";
    set("floor", simulation->bounds().low.y() - 0.1);
    const int fast = step();
    EXPECT_GT(fast, slow);
    set("gravity", Vec3(0, -9.81, 0));
    set("air_drag", 5.0);
    run(400);
    EXPECT_LT(step(), fast) << "at rest again";
    EXPECT_NEAR(simulation->report().volumeRatio, 1, 0.01);
}

TEST_F(AutoIterationsTest, AreThoseOfTheDefaultsWithPlainPbd) {
    Params params = autoParams();
    params.solver = SolverMode::pbd;
    start(params);
    EXPECT_EQ(step(), kUsualSweeps);
}

TEST_F(AutoIterationsTest, AMomentAndAReplayGiveTheSameBits) {
    start(autoParams());
    simulation->setUndoBudget(1 << 28);
    run(3);
    const Checkpoint then = simulation->checkpoint();
    const Course first = playScene();
    const auto [least, most] = std::ranges::minmax(first.iterations);
    EXPECT_GT(most, least) << "the number changes";
    simulation->goTo(then);
    EXPECT_EQ(playScene(), first) << "from a checkpoint";
    start(autoParams());
    simulation->setUndoBudget(1 << 28);
    run(3);
    EXPECT_EQ(playScene(), first) << "from the start";
}

/// A checkpoint in the middle, with another body and other parameters between.
TEST_F(AutoIterationsTest, SeekingBackAcrossACutAndOtherMaterialsGivesTheSameBits) {
    Params params = autoParams();
    params.skinThickness = 0.005;  // constraints follow every parameter
    start(params);
    simulation->setUndoBudget(1 << 28);
    run(10);
    const Checkpoint before = simulation->checkpoint();
    const Course first = playScene();
    const Checkpoint after = simulation->checkpoint();
    const Course later = play(10);
    simulation->goTo(before);
    EXPECT_EQ(playScene(), first);
    EXPECT_EQ(play(10), later);
    simulation->goTo(before);
    simulation->goTo(after);
    EXPECT_EQ(play(10), later);
}

}  // namespace
}  // namespace kerf

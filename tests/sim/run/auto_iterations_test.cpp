// Iterations that the simulation chooses before each step.
#include <gtest/gtest.h>

#include "sim/mesh/invariants.h"
#include "tests/support/shapes.h"
#include "tests/support/simulation_fixture.h"

namespace kerf {
namespace {

/// The iterations of steps, and what these led to.
struct Course {
    std::vector<int> iterations;
    std::string hash;
    bool operator==(const Course&) const = default;
};

class AutoIterationsTest : public test::SimulationTest {
  protected:
    static Params autoParams() {
        Params params = ofNewScene(Params{});
        params.sleeps = 0;
        params.floor = -0.6;
        return params;
    }
    void start(const Params& params) { simulation.emplace(test::cubeSphere(4, 0.5), params); }
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
    const Moment moment = simulation->moment();
    const Course first = playScene();
    const auto [least, most] = std::ranges::minmax(first.iterations);
    EXPECT_GT(most, least) << "the number changes";
    simulation->goTo(moment);
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
    const Moment before = simulation->moment();
    const Course first = playScene();
    const Moment after = simulation->moment();
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

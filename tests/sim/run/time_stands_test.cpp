// Steps while time stands: the blade alone acts.
#include <gmock/gmock.h>

#include "tests/support/shapes.h"
#include "tests/support/simulation_fixture.h"

namespace kerf {
namespace {

Params falling() {
    Params params;
    params.iterations = 4;
    params.floor = -0.8;
    return params;
}

class TimeStandsTest : public test::SimulationTest {
  protected:
    void SetUp() override {
        SimulationTest::SetUp();
        simulation.emplace(test::cubeSphere(6, 0.5), falling());
    }
    void letTimeRun(bool runs) { EXPECT_EQ(simulation->execute(SetTime{runs}), ""); }
    void cutThrough(double x) {
        for (int i = 0; i <= 20; ++i) {
            const double y = 0.7 - 2.0 * i / 20;
            ASSERT_EQ(simulation->execute(MoveBlade{{{x, y, -1}, {x, y, 1}}}), "");
            simulation->step();
        }
        simulation->execute(LiftBlade{});
        simulation->step();
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
}

TEST_F(TimeStandsTest, TheHalvesFallOnceTimeRunsAgain) {
    letTimeRun(false);
    cutThrough(0.02);
    const double high = simulation->bounds().center().y();
    letTimeRun(true);
    run(40);
    EXPECT_LT(simulation->bounds().center().y(), high - 0.01);
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

TEST_F(TimeStandsTest, AResetLetsItRun) {
    letTimeRun(false);
    simulation->reset();
    EXPECT_TRUE(simulation->timeRuns());
}

TEST_F(TimeStandsTest, AMomentKnowsThatItStood) {
    letTimeRun(false);
    const Moment moment = simulation->moment();
    letTimeRun(true);
    run(3);
    simulation->goTo(moment);
    EXPECT_FALSE(simulation->timeRuns());
}

}  // namespace
}  // namespace kerf

// What a step asks of the driver, as docs/benchmarks.md promises it.
#include "gpu/traffic.h"

#include <gtest/gtest.h>

#include <functional>

#include "tests/support/shapes.h"
#include "tests/support/simulation_fixture.h"

namespace kerf {
namespace {

class TrafficTest : public test::SimulationTest {
  protected:
    void open(const Params& params, int side = 6) {
        simulation.emplace(test::cubeSphere(side, 0.5), params);
        run(3);
    }
    gpu::Traffic during(const std::function<void()>& act) {
        const gpu::Traffic before = gpu::traffic();
        act();
        return gpu::traffic() - before;
    }
    gpu::Traffic ofStep() {
        return during([this] { run(1); });
    }
    void cutAt(double x) {
        for (int i = 0; i <= 20; ++i) {
            const double y = 0.7 - 1.4 * i / 20;
            ASSERT_EQ(simulation->execute(MoveBlade{{{x, y, -1}, {x, y, 1}}}), "");
            run(1);
        }
        simulation->execute(LiftBlade{});
        run(1);
    }
};

TEST_F(TrafficTest, AStepThatFallsFreelyWaitsOnce) {
    Params params;
    params.floor.reset();
    open(params);
    for (int i = 0; i < 10; ++i) {
        const gpu::Traffic step = ofStep();
        EXPECT_LE(step.waits + step.reads, 1u) << "step " << i;
        EXPECT_GT(step.dispatches, 0u);
    }
}

TEST_F(TrafficTest, AStepAtRestWaitsOnceAndSendsNextToNothing) {
    open(test::weightless());
    const gpu::Traffic step = ofStep();
    EXPECT_LE(step.waits + step.reads, 1u);
    EXPECT_LT(step.bytesUp, 4096u);
}

TEST_F(TrafficTest, WhileTimeStandsNothingIsDispatched) {
    open(test::weightless());
    simulation->execute(SetTime{false});
    run(1);
    EXPECT_EQ(ofStep().dispatches, 0u);
}

TEST_F(TrafficTest, MorePiecesAreNoMoreDispatches) {
    Params params = test::weightless();
    params.contact = 0;
    constexpr int kTooLargeForOneGroup = 20;
    open(params, kTooLargeForOneGroup);
    const std::uint64_t whole = ofStep().dispatches;
    for (const double x : {-0.25, 0.01, 0.25}) {
        cutAt(x);
    }
    ASSERT_EQ(simulation->report().pieces, 4);
    run(2);
    EXPECT_EQ(ofStep().dispatches, whole);
}

}  // namespace
}  // namespace kerf

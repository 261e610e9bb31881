#include "app/session/real_time_factor.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "sim/base/text.h"
#include "sim/run/simulation.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/shapes.h"

namespace kerf::app {
namespace {

using ::testing::HasSubstr;
using ::testing::Optional;

TEST(RealTimeFactor, IsSimulatedTimeOverThatOfTheClock) {
    EXPECT_THAT(realTimeFactor(0.005, 5), Optional(1.0));
    EXPECT_THAT(realTimeFactor(0.005, 50), Optional(0.1));
    EXPECT_EQ(realTimeFactor(0, 5), std::nullopt) << "time is paused";
    EXPECT_EQ(realTimeFactor(0.005, 0), std::nullopt);
}

TEST(RealTimeFactor, HasTwoDigits) {
    EXPECT_EQ(factorText(0.03728), "0.037x");
    EXPECT_EQ(factorText(1), "1x");
    EXPECT_EQ(factorText(123.4), "123x");
}

TEST(RealTimeFactor, OfARunHasTheMiddleAndTheWorstStep) {
    RealTimeFactors factors;
    for (const double ms : {10.0, 40.0, 20.0}) factors.add(0.01, ms, 0);
    factors.add(0, 1000, 1000);
    EXPECT_THAT(factors.median(), Optional(0.5));
    EXPECT_THAT(factors.worst(), Optional(0.25));
    EXPECT_THAT(factors.withDrawing(), Optional(testing::DoubleEq(0.03 / 0.07)))
        << "a pause does not count, nor does what is drawn in it";
    EXPECT_EQ(factors.sentence(),
              "0.03 s simulated in 0.07 s, 0.43x real time (slowest step 0.25x)");
    factors.add(0.01, 10, 80);
    EXPECT_THAT(factors.withDrawing(), Optional(testing::DoubleEq(0.04 / 0.16)));
    EXPECT_THAT(factors.sentence(), HasSubstr("0.25x with pictures"));
    EXPECT_EQ(toJson(factors)["worst"], 0.25);
}

TEST(RealTimeFactor, IsNoneWhereNoTimePassed) {
    RealTimeFactors factors;
    factors.add(0, 10, 10);
    const auto written = toJson(factors);
    for (const char* key : {"median", "worst", "with_drawing"}) {
        EXPECT_TRUE(written.at(key).is_null()) << key;
    }
    EXPECT_EQ(factors.sentence(), "none was simulated");
}

class TimeOfAStep : public test::GlTest {};

TEST_F(TimeOfAStep, IsTheTimeStepUnlessPaused) {
    Params params;
    params.timeStep = 0.004;
    Simulation simulation(test::cubeSphere(1), params);
    simulation.step();
    EXPECT_EQ(secondsOfStep(simulation), 0.004);
    simulation.execute(SetTime{false});
    simulation.step();
    EXPECT_EQ(secondsOfStep(simulation), 0);
}

}  // namespace
}  // namespace kerf::app

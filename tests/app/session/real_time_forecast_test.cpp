#include <gtest/gtest.h>

#include "app/session/real_time_factor.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/shapes.h"

namespace kerf::app {
namespace {

class RealTimeForecastTest : public test::GlTest {
  protected:
    Params params_ = ofNewScene({});
};

TEST_F(RealTimeForecastTest, IsThatOfTheTimeStepWithItsIterations) {
    params_.timeStep = 0.004;
    const RealTimeForecast forecast = realTimeForecast(test::cubeSphere(4), params_);
    EXPECT_GT(forecast.factor, 0);
    EXPECT_EQ(forecast.timeStep, 0.004);
    EXPECT_GT(forecast.iterations, 0);
    params_.iterations = 7;
    EXPECT_EQ(realTimeForecast(test::cubeSphere(4), params_).iterations, 7);
}

TEST_F(RealTimeForecastTest, ABallStandsInForALargeBodyAndItsTimesAreScaled) {
    const RealTimeForecast large = realTimeForecast(test::cubeSphere(33), params_);
    const RealTimeForecast larger = realTimeForecast(test::cubeSphere(132), params_);
    EXPECT_GT(larger.factor, 0);
    EXPECT_GT(large.scale, 1);
    EXPECT_GT(larger.scale, 10 * large.scale);
    EXPECT_GE(larger.iterations, large.iterations);
    params_.iterations = 7;
    EXPECT_EQ(realTimeForecast(test::cubeSphere(33), params_).iterations, 7) << "as it was said";
}

TEST_F(RealTimeForecastTest, OfImplicitStepsTellsTheirNumberWhichNoSizeChanges) {
    params_.solver = SolverMode::implicit;
    params_.timeStep = 0.02;
    const RealTimeForecast large = realTimeForecast(test::cubeSphere(33), params_);
    const RealTimeForecast larger = realTimeForecast(test::cubeSphere(66), params_);
    EXPECT_EQ(large.implicitSteps, 2) << "longer than the longest step of any body";
    EXPECT_GT(larger.scale, 3 * large.scale);
    EXPECT_EQ(larger.iterations, large.iterations);
}

}  // namespace
}  // namespace kerf::app

#include "bench/lab/blade_experiment.h"

#include <gtest/gtest.h>

#include "tests/support/gl_fixture.h"

namespace kerf::app {
namespace {

class BladeExperimentTest : public test::GlTest {};

TEST_F(BladeExperimentTest, ABladeFeelsNothingAboveTheBlockAndBreaksIntoIt) {
    Params params;
    params.gravity.setZero();
    params.floor.reset();
    params.timeStep = 0.02;
    params.iterations = 2;
    params.airDrag = 2;
    params.damping = 0;
    params.youngsModulus = 1e4;
    params.toughness = 5;
    params.bladeFeels = 1;
    const BladeRun run = measureBlade("soft", params);
    ASSERT_FALSE(run.points.empty());
    EXPECT_LT(run.points.front().depth, 0);
    for (const BladePoint& point : run.points) {
        if (point.depth < 0) {
            EXPECT_EQ(point.force, 0) << point.depth;
            EXPECT_EQ(point.fracture, 0) << point.depth;
        }
    }
    EXPECT_GT(run.rupture().force, 0);
    EXPECT_GT(run.rupture().depth, 0);
    EXPECT_GT(run.points.back().fracture, 0);
    EXPECT_GT(run.points.back().work, 0);
}

}  // namespace
}  // namespace kerf::app

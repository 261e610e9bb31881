#include "app/session/iteration_watch.h"

#include <gtest/gtest.h>

namespace kerf::app {
namespace {

constexpr double kMeanEdge = 0.03;  // [m]

Params withModulus(double modulus) {
    Params params;
    params.youngsModulus = modulus;
    return params;
}

TEST(IterationWatch, SaysNothingWhereAllStepsHadEnough) {
    IterationWatch watch(kMeanEdge);
    watch.add(0, Params{});
    EXPECT_EQ(watch.sentence(), "");
}

TEST(IterationWatch, NamesTheWorstStepAndWhatWouldDo) {
    IterationWatch watch(kMeanEdge);
    watch.add(0, Params{});
    watch.add(1, withModulus(2e6));
    watch.add(2, withModulus(1e7));
    watch.add(3, withModulus(1e7));
    EXPECT_EQ(watch.sentence(),
              "Step 2: 20 iterations are too few for youngs_modulus 10000000 at time_step 0.005, "
              "so the body is softer than its modulus; from 58 on it is not (3 of 4 steps have too "
              "few).");
}

TEST(IterationWatch, AsksForASmallerTimeStepWhereNoNumberOfIterationsWouldDo) {
    IterationWatch watch(kMeanEdge);
    Params params = withModulus(1e8);
    params.stretchStiffness = 2;
    params.iterations = 1;
    watch.add(0, params);
    EXPECT_EQ(watch.sentence(),
              "Step 0: 1 iteration is too few for youngs_modulus 100000000 times "
              "stretch_stiffness 2 at time_step 0.005, so the body is softer than its modulus; a "
              "smaller time_step helps (1 of 1 steps have too few).");
}

TEST(IterationWatch, PlainPbdHasNoModulus) {
    IterationWatch watch(kMeanEdge);
    Params params = withModulus(1e8);
    params.solver = SolverMode::pbd;
    watch.add(0, params);
    EXPECT_EQ(watch.sentence(), "");
}

}  // namespace
}  // namespace kerf::app

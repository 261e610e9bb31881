#include "app/session/iteration_watch.h"

#include <gtest/gtest.h>

#include "sim/body/body_updater.h"
#include "tests/support/shapes.h"
#include "tests/support/small_steps.h"

namespace kerf::app {
namespace {

BodyModel ball() {
    return buildBodyModel(test::builtin("sphere768"));
}

Params withModulus(double modulus) {
    Params params = test::smallSteps();
    params.youngsModulus = modulus;
    return params;
}

TEST(IterationWatch, SaysNothingWhereAllStepsHadEnough) {
    IterationWatch watch;
    watch.add(0, ball(), test::smallSteps());
    EXPECT_EQ(watch.sentence(), "");
}

TEST(IterationWatch, NamesTheWorstStepAndWhatWouldDo) {
    const BodyModel body = ball();
    IterationWatch watch;
    watch.add(0, body, test::smallSteps());
    watch.add(1, body, withModulus(2e7));
    watch.add(2, body, withModulus(3e7));
    watch.add(3, body, withModulus(3e7));
    const std::string sentence = watch.sentence();
    EXPECT_EQ(sentence.find("Step 2: 20 iterations are too few for youngs_modulus 30000000 at "
                            "time_step 0.005, so the body is softer than its modulus; from "),
              0u)
        << sentence;
    EXPECT_NE(sentence.find(" on it is not (3 of 4 steps have too few)."), std::string::npos)
        << sentence;
}

TEST(IterationWatch, AsksForASmallerTimeStepWhereNoNumberOfIterationsWouldDo) {
    IterationWatch watch;
    Params params = withModulus(1e8);
    params.stretchStiffness = 2;
    params.iterations = 1;
    params.timeStep = 0.02;
    watch.add(0, ball(), params);
    EXPECT_EQ(watch.sentence(),
              "Step 0: 1 iteration is too few for youngs_modulus 100000000 times "
              "stretch_stiffness 2 at time_step 0.02, so the body is softer than its modulus; a "
              "smaller time_step helps (1 of 1 steps have too few).");
}

TEST(IterationWatch, SaysWhereEvenTheMostAutoIterationsLeaveALargerError) {
    IterationWatch watch;
    Params params = withModulus(1e6);
    params.trueModulus = 1;
    params.iterations = kAutoIterations;
    BodyUpdater body(test::builtin("sphere768"));
    body.castIspcs(IspcRays::turned);
    watch.add(0, body.model(), params);
    EXPECT_EQ(watch.sentence(), "");
    params.youngsModulus = 1e8;
    watch.add(1, body.model(), params);
    EXPECT_EQ(watch.sentence(),
              "Step 1: even the most iterations are too few for youngs_modulus 100000000 at "
              "time_step 0.005 and iteration_error 0.02; a smaller time_step helps (1 of 2 steps "
              "have too few).");
}

TEST(IterationWatch, SpeaksOfSmallStepsAlone) {
    IterationWatch watch;
    Params params = withModulus(1e8);
    for (const SolverMode solver : {SolverMode::pbd, SolverMode::implicit}) {
        for (const int iterations : {1, kAutoIterations}) {
            params.solver = solver;
            params.iterations = iterations;
            watch.add(0, ball(), params);
        }
    }
    EXPECT_EQ(watch.sentence(), "");
}

}  // namespace
}  // namespace kerf::app

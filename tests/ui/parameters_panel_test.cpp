#include <gtest/gtest.h>

#include <cstdio>

#include "sim/body/body_model.h"
#include "sim/solve/sweep_strength.h"
#include "tests/support/shapes.h"
#include "ui/panels/panels.h"
#include "ui/state/panel_model.h"

namespace kerf::ui {
namespace {

std::string shown(std::string_view name, double value) {
    char text[64];
    std::snprintf(text, sizeof text, sliderFormat(*findParam(name)).c_str(), value);
    return text;
}

TEST(SliderFormat, ShowsTheUnitAndDecimalsThatSuitTheRange) {
    EXPECT_EQ(shown("time_step", 0.005), "0.0050 s");
    EXPECT_EQ(shown("ispc_stiffness", 0.5), "0.50");
    EXPECT_EQ(shown("gravity", -9.81), "-9.81 m/s\u00b2");
    EXPECT_EQ(shown("youngs_modulus", 1e5), "100000 Pa");
    EXPECT_EQ(sliderFormat(*findParam("iterations")), "%d");
}

TEST(SliderFormat, LosesNothingOfTheSmallestValue) {
    for (const ParamInfo& info : paramTable()) {
        if (info.type != ParamType::real || info.low <= 0) {
            continue;
        }
        // What a slider writes back is what it shows: the lower end has to survive that.
        EXPECT_NEAR(std::atof(shown(info.name, info.low).c_str()), info.low, 0.5 * info.low)
            << info.name;
        EXPECT_GT(std::atof(shown(info.name, info.low).c_str()), 0) << info.name;
    }
}

TEST(RemarkOn, AutoIterationsOfWhichEvenTheMostAreTooFew) {
    PanelModel model;
    Params& now = model.parameters.now;
    now.solver = SolverMode::smallSteps;
    now.iterations = kAutoIterations;
    const SweepStrength strength(buildBodyModel(test::builtin("sphere768")), now);
    model.parameters.sweeps = &strength;
    EXPECT_EQ(remarkOn(*findParam("iterations"), model.parameters), "");
    now.youngsModulus = 1e8;
    const std::string remark = remarkOn(*findParam("iterations"), model.parameters);
    EXPECT_EQ(remark.find("The maximum leaves an error of about "), 0U) << remark;
}

TEST(RemarkOn, IterationsThatAreTooFewForTheModulus) {
    const ParamInfo& iterations = *findParam("iterations");
    PanelModel model;
    model.parameters.now.solver = SolverMode::smallSteps;
    model.parameters.now.iterations = kUsualSweeps;
    model.parameters.now.youngsModulus = 3e7;
    EXPECT_EQ(remarkOn(iterations, model.parameters), "") << "nothing is open";
    const SweepStrength strength(buildBodyModel(test::builtin("sphere768")), model.parameters.now);
    model.parameters.sweeps = &strength;
    const std::optional<int> enough = strength.enoughIterations(model.parameters.now);
    ASSERT_TRUE(enough);
    EXPECT_NE(remarkOn(iterations, model.parameters)
                  .find("Use at least " + std::to_string(*enough) + "."),
              std::string::npos)
        << remarkOn(iterations, model.parameters);
    EXPECT_EQ(remarkOn(*findParam("time_step"), model.parameters), "");
    model.parameters.now.iterations = *enough;
    EXPECT_EQ(remarkOn(iterations, model.parameters), "");
    model.parameters.now.timeStep = 0.02;
    model.parameters.now.youngsModulus = 1e8;
    EXPECT_NE(remarkOn(iterations, model.parameters).find("% too soft."), std::string::npos);
    EXPECT_EQ(remarkOn(iterations, model.parameters).find("Use"), std::string::npos);
    model.parameters.now.solver = SolverMode::pbd;
    EXPECT_EQ(remarkOn(iterations, model.parameters), "") << "its stiffness is no modulus";
}

TEST(RemarkOn, WhatAStepWithTheImplicitSolverIsMadeOf) {
    PanelModel model;
    ParametersState& parameters = model.parameters;
    parameters.now.youngsModulus = 1e8;  // too much for as many small steps
    parameters.now.solver = SolverMode::implicit;
    parameters.implicitSteps = 2;
    parameters.iterations = 6;
    const SweepStrength strength(buildBodyModel(test::builtin("sphere768")), parameters.now);
    parameters.sweeps = &strength;
    EXPECT_EQ(remarkOn(*findParam("iterations"), parameters),
              "2 implicit steps of 2.5 ms, 6 iterations");
    parameters.implicitSteps = 1;
    EXPECT_EQ(partsOfStep(parameters), "1 implicit step of 5 ms, 6 iterations");
    parameters.now.solver = SolverMode::smallSteps;
    EXPECT_EQ(partsOfStep(parameters), "6 iterations");
}

}  // namespace
}  // namespace kerf::ui

#include <gtest/gtest.h>

#include <cstdio>

#include "sim/body/body_model.h"
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

TEST(RemarkOn, WhatAStepIsMadeOf) {
    ParametersState parameters;
    const ParamInfo& iterations = *findParam("iterations");
    EXPECT_EQ(remarkOn(iterations, parameters), "") << "nothing is open";
    parameters.implicitSteps = 2;
    parameters.iterations = 6;
    EXPECT_EQ(remarkOn(iterations, parameters), "2 implicit steps of 2.5 ms, 6 iterations");
    EXPECT_EQ(remarkOn(*findParam("time_step"), parameters), "");
    parameters.implicitSteps = 1;
    EXPECT_EQ(partsOfStep(parameters), "1 implicit step of 5 ms, 6 iterations");
    parameters.residual = 0.0213;
    EXPECT_EQ(partsOfStep(parameters), "1 implicit step of 5 ms, 6 iterations (left: 2 %)");
    parameters.residual.reset();
    parameters.now.solver = SolverMode::pbd;
    EXPECT_EQ(partsOfStep(parameters), "6 iterations");
    EXPECT_EQ(remarkOn(iterations, parameters), "");
}

}  // namespace
}  // namespace kerf::ui

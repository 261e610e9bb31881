#include "app/session/iteration_watch.h"

#include <spdlog/fmt/fmt.h>

#include "sim/base/text.h"

namespace kerf::app {

namespace {

/// "youngs_modulus 500000", with the factor on it where there is one.
std::string stiffnessOf(const Params& params) {
    const std::string modulus = fmt::format("youngs_modulus {}", params.youngsModulus);
    return params.stretchStiffness == 1
               ? modulus
               : fmt::format("{} times stretch_stiffness {}", modulus, params.stretchStiffness);
}

}  // namespace

void IterationWatch::add(int step, const BodyModel& body, const Params& params) {
    ++steps_;
    strength_.follow(body, params);
    if (!strength_.isTooLittle(params)) {
        return;
    }
    ++weakSteps_;
    if (const double carried = strength_.carried(params); carried < least_) {
        least_ = carried;
        worstStep_ = step;
        worst_ = params;
    }
}

std::string IterationWatch::sentence() const {
    if (weakSteps_ == 0) {
        return "";
    }
    const std::string steps = fmt::format("({} of {} steps have too few)", weakSteps_, steps_);
    if (worst_.iterations == kAutoIterations) {
        return fmt::format(
            "Step {}: even the most iterations are too few for {} at time_step {} and "
            "iteration_error {}; a smaller time_step helps {}.",
            worstStep_, stiffnessOf(worst_), worst_.timeStep, worst_.iterationError, steps);
    }
    const std::optional<int> enough = strength_.enoughIterations(worst_);
    const std::string advice =
        enough ? fmt::format("from {} on it is not", *enough) : "a smaller time_step helps";
    return fmt::format(
        "Step {}: {} too few for {} at time_step {}, so the body is softer than its modulus; {} "
        "{}.",
        worstStep_, counted(worst_.iterations, "iteration is", "iterations are"),
        stiffnessOf(worst_), worst_.timeStep, advice, steps);
}

}  // namespace kerf::app

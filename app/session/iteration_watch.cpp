#include "app/session/iteration_watch.h"

#include <spdlog/fmt/fmt.h>

#include "sim/base/text.h"
#include "sim/solve/sweep_strength.h"

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

void IterationWatch::add(int step, const Params& params) {
    ++steps_;
    if (!hasTooFewSweeps(params, edgeLength_)) {
        return;
    }
    ++weakSteps_;
    if (const double strength = sweepStrength(params, edgeLength_); strength < least_) {
        least_ = strength;
        worstStep_ = step;
        worst_ = params;
    }
}

std::string IterationWatch::sentence() const {
    if (weakSteps_ == 0) {
        return "";
    }
    const std::optional<int> enough = enoughIterations(worst_, edgeLength_);
    const std::string advice =
        enough ? fmt::format("from {} on it is not", *enough) : "a smaller time_step helps";
    return fmt::format(
        "Step {}: {} too few for {} at time_step {}, so the body is softer than its modulus; {} "
        "({} of {} steps have too few).",
        worstStep_, counted(worst_.iterations, "iteration is", "iterations are"),
        stiffnessOf(worst_), worst_.timeStep, advice, weakSteps_, steps_);
}

}  // namespace kerf::app

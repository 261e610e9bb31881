#include "sim/solve/sweep_strength.h"

#include <cmath>

#include "sim/body/solver_uniforms.h"

namespace kerf {

double sweepStrength(const Params& params, double edgeLength) {
    const double substep = params.timeStep / params.iterations;
    const double modulus = params.youngsModulus * params.stretchStiffness;
    const double strength =
        params.density * edgeLength * edgeLength / (12 * modulus * substep * substep);
    constexpr double kEnough = 0.75 * static_cast<double>(shared::kSweepRoom);
    return hasTrueModulus(params) ? strength / (modulusShare(shared::kStretch, params) * kEnough)
                                  : strength;
}

bool hasTooFewSweeps(const Params& params, double edgeLength) {
    return params.solver == SolverMode::smallSteps && sweepStrength(params, edgeLength) < 1;
}

std::optional<int> enoughIterations(const Params& params, double edgeLength) {
    const double wanted =
        std::ceil(params.iterations / std::sqrt(sweepStrength(params, edgeLength)));
    return wanted <= findParam("iterations")->high ? std::optional(static_cast<int>(wanted))
                                                   : std::nullopt;
}

}  // namespace kerf

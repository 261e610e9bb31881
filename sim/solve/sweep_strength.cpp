#include "sim/solve/sweep_strength.h"

#include <cmath>

#include "sim/body/solver_uniforms.h"

namespace kerf {

double sweepStrength(const Params& params, double edgeLength) {
    const double substep = params.timeStep / params.iterations;
    const double modulus = params.youngsModulus * params.stretchStiffness;
    const double strength =
        params.density * edgeLength * edgeLength / (12 * modulus * substep * substep);
    if (!hasTrueModulus(params)) {
        return strength;
    }
    const double least = 0.75 * sweepRoom(shared::kStretch);
    return strength / (modulusShare(shared::kStretch, params) * least);
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

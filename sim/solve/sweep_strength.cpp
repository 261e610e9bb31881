#include "sim/solve/sweep_strength.h"

#include <cmath>

namespace kerf {

double sweepStrength(const Params& params, double edgeLength) {
    const double substep = params.timeStep / params.iterations;
    const double modulus = params.youngsModulus * params.stretchStiffness;
    return params.density * edgeLength * edgeLength / (12 * modulus * substep * substep);
}

int iterationsForModulus(const Params& params, double edgeLength) {
    return static_cast<int>(
        std::ceil(params.iterations / std::sqrt(sweepStrength(params, edgeLength))));
}

}  // namespace kerf

#pragma once

#include "sim/base/params.h"

namespace kerf::test {

/// These parameters with small_steps of the usual number, as large bodies have it, and those whose
/// blade feels.
inline Params smallSteps(Params params = {}) {
    params.solver = SolverMode::smallSteps;
    params.iterations = kUsualSweeps;
    return params;
}

inline bool isImplicit(const Params& params) {
    return params.solver == SolverMode::implicit;
}

}  // namespace kerf::test

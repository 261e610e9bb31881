#pragma once

#include "sim/base/params.h"

namespace kerf::test {

/// Parameters of a scene that is solved by small_steps, of the usual number.
inline Params smallSteps() {
    Params params;
    params.solver = SolverMode::smallSteps;
    params.iterations = kUsualSweeps;
    return params;
}

}  // namespace kerf::test

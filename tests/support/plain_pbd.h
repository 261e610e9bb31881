#pragma once

#include "sim/base/params.h"

namespace kerf::test {

/// These parameters with the paper's solver.
inline Params plainPbd(Params params = {}) {
    params.solver = SolverMode::pbd;
    return params;
}

}  // namespace kerf::test

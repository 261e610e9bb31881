#pragma once

#include "sim/body/body_model.h"
#include "tests/support/reference/reference_solver.h"

namespace kerf {

/// Does in doubles what Unfolding does on the GPU: changes the velocities of a state between
/// substeps, and sets its folds. `inverseMass`: per vertex [1/kg]. `uniforms`: of the substep;
/// without its counts.
void unfoldAsReference(const BodyModel& model, const std::vector<double>& inverseMass,
                       const shared::SolverUniforms& uniforms, ReferenceState& state);

}  // namespace kerf

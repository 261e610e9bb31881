#pragma once

#include <vector>

#include "sim/body/body_model.h"
#include "sim/solve/reference_solver.h"

namespace kerf {

/// What Unfolding does on the GPU, in doubles: changes the velocities of a state between substeps,
/// and says how far it is folded.
/// `inverseMass`: per vertex [1/kg]. `substep` [s].
void unfoldAsReference(const BodyModel& model, const std::vector<double>& inverseMass,
                       double substep, ReferenceState& state);

}  // namespace kerf

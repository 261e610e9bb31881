#pragma once

#include "sim/reference/reference_solver.h"

namespace kerf {

/// The energy that BodyMeasure::strainEnergy is compared with [J]: the sum of C^2 / (2 alpha) over
/// the constraints that are on and not rigid, beyond the clamp of a bend with the moment that it
/// has there.
double strainEnergy(const BodyModel& model, const shared::SolverUniforms& uniforms,
                    const ReferenceState& state);

}  // namespace kerf

#pragma once

#include "shaders/shared/solver_uniforms.h"
#include "sim/body/body_model.h"
#include "sim/params.h"

namespace kerf {

/// Young's modulus of the ISPCs as a multiple of the body's: (s / (1 - s))^2 for a stiffness s.
/// 0 at s = 0 (no ISPCs), 1 at 0.5 (the material itself), unbounded at 1 (rigid constraints, as
/// firm as one solver iteration per substep gets). Rises strictly.
double ispcModulusFactor(double stiffness);

/// What the parameters mean for one substep h = timeStep / iterations; counts are 0.
shared::SolverUniforms solverUniforms(const Params& params);

/// Sets the counts to those of `model`.
void setCounts(shared::SolverUniforms& uniforms, const BodyModel& model);

/// solverUniforms(params) with the counts of `model`.
shared::SolverUniforms solverUniforms(const Params& params, const BodyModel& model);

}  // namespace kerf

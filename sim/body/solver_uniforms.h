#pragma once

#include "shaders/shared/solver_uniforms.h"
#include "sim/base/params.h"
#include "sim/body/body_model.h"
#include "sim/body/ispc_builder.h"

namespace kerf {

/// Young's modulus of the ISPCs as a multiple of the body's: (s / (1 - s))^2 for a stiffness s.
/// 0 at s = 0 (no ISPCs), 1 at 0.5 (the material itself), unbounded at 1 (rigid constraints).
/// Rises strictly.
double ispcModulusFactor(double stiffness);

/// Young's modulus of a type of constraints (shared::kStretch, ...) as a multiple of the body's: by
/// its stiffness, times its share of the load, with which the body is as stiff as its modulus says.
/// Plain PBD has none.
double modulusFactor(shared::uint type, const Params& params);

/// How ISPCs are cast: turned, or with plain PBD along the normal as in the paper.
IspcRays ispcRays(const Params& params);

/// k' = 1 - (1 - k)^(1/n): the share of a correction that each of `sweeps` = n sweeps of plain PBD
/// applies, so that a stiffness k means the same for any n (Mueller et al. 2007). k is clamped to
/// 0..1.
double sweepStiffness(double stiffness, int sweeps);

/// Whether pieces keep their volumes: not in the paper's solver, and not without ISPCs, where a
/// hollow body can be squeezed flat.
bool holdsVolume(const Params& params);

/// Whether an unloaded piece has its rest shape: edges, bends and ISPCs are all on.
bool keepsShape(const Params& params);

/// At which folded skin and the front of a slit catch up with where they belong, at most: a tenth
/// of the speed of a wave in a bar of the scene's material, or 1 m/s if that is more [m/s]. Without
/// a bound single vertices of an opened slit reached 15 m/s. With 1 m/s alone large firm bodies are
/// left behind.
double catchUpSpeed(const Params& params);

/// Length of a stage of an implicit step (SDIRK2) [s].
double stageOf(double step);
/// How firm constraints may be in implicit steps of this length [s], over the sum of
/// |grad C|^2 / mass: see shared::kMostFirmness. [1/s^2]
double firmestIn(double step);

/// Iterations as a number: auto ones are those of the defaults where there is no body to choose
/// for.
int numberOfIterations(const Params& params);
/// The parameters as the solver reads them; counts are 0. SolverMode::pbd: `iterations` sweeps,
/// with stiffness factors and without a volume constraint.
shared::SolverUniforms solverUniforms(const Params& params);

/// Sets the counts to those of `model`.
void setCounts(shared::SolverUniforms& uniforms, const BodyModel& model);

/// solverUniforms(params) with the counts of `model`.
shared::SolverUniforms solverUniforms(const Params& params, const BodyModel& model);

}  // namespace kerf

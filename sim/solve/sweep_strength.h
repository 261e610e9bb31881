#pragma once

#include <optional>

#include "sim/base/params.h"

namespace kerf {

/// How strong one Jacobi sweep a substep is against what an edge constraint asks for: r = (alpha /
/// h^2) / (2 n w) of mass-splitting XPBD, where n = 6 equal edges of length L meet at a vertex.
/// By geometry, which gives alpha and w, it is rho L^2 / (12 E h^2). Far above 1 the body is as
/// stiff as its modulus says; below 1 it is softer, whatever the modulus (docs/physics.md,
/// Effective modulus). With `true_modulus` it is r over the least r at which the edges are as stiff
/// as they should be (sweepRoom()). `edgeLength` is the mean at rest [m]; `small_steps` is
/// assumed.
double sweepStrength(const Params& params, double edgeLength);

/// Whether that is below 1. Never with plain PBD, whose stiffness is no modulus.
bool hasTooFewSweeps(const Params& params, double edgeLength);

/// Least number of iterations for which it is 1; none where the range of the parameter ends before.
std::optional<int> enoughIterations(const Params& params, double edgeLength);

}  // namespace kerf

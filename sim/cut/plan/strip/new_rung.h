#pragma once

#include "sim/cut/plan/input/step.h"
#include "sim/cut/plan/strip/strip.h"

namespace kerf::cut {

/// The sideways offset, as a share of h, of a blade that stays in its plane: exact predicates need
/// no more to avoid degenerate cases.
inline constexpr double kLeastOffset = 1e-9;
/// The fixed displacement [m] of a blade at parameter s for an offset of `length` [m] at scale 1.
Vec3 bladeOffset(double length, double scale, std::uint64_t seed, int transit, double s);

/// The nodes of the new rung of a step, from A to B: one ahead of each inner node of the front,
/// except at the parameters `skipped`. Nothing where an end stays at that of the old rung. `strip`
/// has only the old rung yet.
std::vector<std::optional<StripNode>> newRung(const StepInput& in, const Strip& strip,
                                              const std::vector<double>& skipped);

}  // namespace kerf::cut

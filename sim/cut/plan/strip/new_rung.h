#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/cut/plan/input/step.h"
#include "sim/cut/plan/strip/strip.h"

namespace kerf::cut {

/// How far, as a share of h, a blade that stays in its plane is led aside: exact predicates need no
/// more, so that it meets nothing exactly.
inline constexpr double kLeastOffset = 1e-9;
/// The fixed displacement [m] of a blade at parameter s for an offset of `length` [m] at scale 1.
Vec3 bladeOffset(double length, double scale, std::uint64_t seed, int transit, double s);

/// The nodes of the rung to which a step leads, from A to B: one ahead of each inner node of the
/// front, but at the parameters `skipped`. Nothing where an end stays at that of the old rung. Of
/// `strip`, the old rung alone is there yet.
std::vector<std::optional<StripNode>> newRung(const StepInput& in, const Strip& strip,
                                              const std::vector<double>& skipped);

}  // namespace kerf::cut

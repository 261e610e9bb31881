#pragma once

#include <cstdint>

#include "sim/cut/plan/step.h"

namespace kerf::cut {

/// The number of levels of the retry ladder: some chosen by measurement, the rest drawn at random.
int attemptCount();

/// The largest Attempt::offsetScale of all levels.
double largestOffsetScale();

/// The level `index` of the ladder. Level 0 takes the blade as it is. Later ones see a front that
/// slipped where it belongs, widen the blade's offset, close older slits, accept touching vertices
/// and move the front, all for the predicates alone. `tolerance`: CutSettings::tolerance, as a
/// share of the edge length around; no level goes below it. `seed` makes the random levels differ
/// from step to step.
Attempt attemptAt(int index, double tolerance, std::uint64_t seed);

}  // namespace kerf::cut

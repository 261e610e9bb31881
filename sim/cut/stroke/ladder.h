#pragma once

#include <cstdint>

#include "sim/cut/plan/step.h"

namespace kerf::cut {

/// Levels of the retry ladder: some chosen by measurement, the rest drawn at random.
int attemptCount();

/// The largest Attempt::offsetScale of all levels.
double largestOffsetScale();

/// Level `index` of the ladder. Level 0 takes the blade as it is. Later ones
/// widen its offset, close older slits, accept touching vertices and move the front virtually.
/// `seed` makes the random levels differ from step to step.
Attempt attemptAt(int index, double tolerance, std::uint64_t seed);

}  // namespace kerf::cut

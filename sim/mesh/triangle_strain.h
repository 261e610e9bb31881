#pragma once

#include "sim/mesh/triangle.h"

namespace kerf {

/// How far a triangle is strained: the larger of its principal strains by amount, which is the
/// change of a length over that length at rest; 0 is as at rest. 0 also where it has no area at
/// rest. The editor colours bodies by the same.
double largestStrain(const Corners& rest, const Corners& now);

}  // namespace kerf

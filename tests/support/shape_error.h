#pragma once

#include "sim/base/math.h"

namespace kerf::test {

/// Root mean square distance between the current positions and the rest positions after the best
/// rotation and translation, over the vertices of `subset` [m]; 0 for an empty one.
/// How far a body is from its shape, wherever it lies.
double rmsShapeError(const std::vector<Vec3>& rest, const std::vector<Vec3>& current,
                     std::span<const int> subset);

}  // namespace kerf::test

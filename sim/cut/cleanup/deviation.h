#pragma once

#include <vector>

#include "sim/cut/cleanup/one_ring.h"

namespace kerf::cut {

/// The largest distance [m] between old and new skin, between old and new walls where only walls
/// change, and between the old and new rim of a wound. `from` merges into `to`, or moves if both
/// are one star.
double deviationOf(const SurfaceMesh& mesh, const SharedStar& from, const SharedStar& to,
                   const std::vector<OneRing>& rings);

}  // namespace kerf::cut

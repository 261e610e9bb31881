#pragma once

#include <vector>

#include "sim/cut/cleanup/local_patch.h"

namespace kerf::cut {

/// The largest distance [m] between old and new skin, between old and new walls where only walls
/// change, and between the old and new rim of a wound. `from` merges into `to`, or moves where
/// both are one star.
double deviationOf(const SurfaceMesh& mesh, const MaterialStar& from, const MaterialStar& to,
                   const std::vector<Patch>& patches);

}  // namespace kerf::cut

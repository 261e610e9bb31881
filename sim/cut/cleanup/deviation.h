#pragma once

#include "sim/cut/cleanup/one_ring.h"
#include "sim/cut/cleanup/workspace.h"

namespace kerf::cut {

/// The largest distance [m] between old and new skin, between old and new walls where only walls
/// change, and between the old and new rim of a wound. `from` merges into `to`, or moves if both
/// are one star.
double deviationOf(const SurfaceMesh& mesh, const SharedStar& from, const SharedStar& to,
                   const std::vector<OneRing>& rings);

/// The largest distance [m] between old and new walls at rest that the other side does not mirror
/// here, as where a cut has divided one wall of an older slit alone: at rest both lie on each
/// other.
double unfacedDeviation(const Workspace& workspace, const std::vector<OneRing>& rings);

}  // namespace kerf::cut

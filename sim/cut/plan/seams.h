#pragma once

#include "sim/cut/plan/intersections.h"

namespace kerf::cut {

/// Adds the seams of a step to `curves`, whose outline must have been traced before. The blade cuts
/// one wall alone where it enters or leaves the gap of an older slit; along a seam the facing wall
/// is divided by the same nodes and segments without being cut, so that walls stay mirrored. Throws
/// StepFailure.
void addSeams(const StepInput& in, CutCurves& curves);

}  // namespace kerf::cut

#pragma once

#include "sim/cut/plan/intersections.h"

namespace kerf::cut {

/// Where the blade enters or leaves the gap of an older slit, it cuts one of its walls alone. The
/// facing wall is divided along the same lines without being cut, so that walls stay mirrored: adds
/// such nodes and segments to `curves`, whose outline must have been traced before. Throws
/// StepFailure.
void addSeams(const StepInput& in, CutCurves& curves);

}  // namespace kerf::cut

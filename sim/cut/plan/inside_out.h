#pragma once

#include <vector>

#include "sim/cut/plan/border_points.h"

namespace kerf::cut {

/// Tells which parts of a strip's border lie inside the body, from where curves end on it
/// (BorderPoint::inside). Two such ends in an order that can't be are swapped where they lie close
/// together. Throws StepFailure where inside and outside contradict each other.
std::vector<BorderPoint> tellInsideOut(const StepInput& in, const Strip& strip,
                                       std::vector<BorderPoint> points);

}  // namespace kerf::cut

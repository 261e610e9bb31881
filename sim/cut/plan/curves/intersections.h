#pragma once

#include "sim/cut/plan/curves/cut_curves.h"
#include "sim/cut/plan/input/predicate_positions.h"
#include "sim/cut/plan/strip/strip.h"

namespace kerf::cut {

/// Finds the exact intersections of surface and strip, with vertices of the front shared by both.
/// Throws StepFailure where the configuration is degenerate or contradicts itself.
CutCurves intersect(const StepInput& in, const Strip& strip, const PredicatePositions& positions);

}  // namespace kerf::cut

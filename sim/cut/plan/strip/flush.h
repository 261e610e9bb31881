#pragma once

#include "sim/cut/plan/input/predicate_positions.h"
#include "sim/cut/plan/strip/strip.h"

namespace kerf::cut {

/// Pins vertices that lie in the strip, to rounding, beside it (PredicatePositions::pinAside):
/// those of faces in its plane on the side of their material, others on the side of their
/// neighbours. So geometry in the blade's plane counts as outside, and no foil comes off. The sides
/// are kept for the transit (StepInput::flushSides). Only predicates see this. Throws StepFailure
/// if the blade meets the end of an older slit or a line where older slits meet.
void seeFlushAside(const StepInput& in, const Strip& strip, PredicatePositions& positions);

}  // namespace kerf::cut

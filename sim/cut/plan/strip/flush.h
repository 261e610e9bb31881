#pragma once

#include "sim/cut/plan/input/predicate_positions.h"
#include "sim/cut/plan/strip/strip.h"

namespace kerf::cut {

/// Pins vertices that lie in the strip, but for rounding, beside it (PredicatePositions::pinAside):
/// those of faces in its plane on the side of their material, others on the side of their
/// neighbours. What lies in the blade's plane so counts as outside, and no foil comes off. The
/// sides hold for the transit (StepInput::flushSides). Nothing real moves. Throws StepFailure where
/// the blade meets the end of an older slit or a line in which older slits meet.
void seeFlushAside(const StepInput& in, const Strip& strip, PredicatePositions& positions);

}  // namespace kerf::cut

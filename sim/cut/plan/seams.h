#pragma once

#include "sim/cut/plan/curves/cut_curves.h"
#include "sim/cut/plan/input/step.h"

namespace kerf::cut {

/// The curves of a step with a traced outline, with its seams. The blade cuts only one wall where
/// it enters or leaves the gap of an older slit; along a seam the facing wall is divided by the
/// same nodes and segments without being cut, so that walls stay mirrored. Throws StepFailure.
CutCurves withSeams(const StepInput& in, CutCurves curves);

}  // namespace kerf::cut

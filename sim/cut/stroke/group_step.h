#pragma once

#include "sim/cut/stroke/stroke.h"

namespace kerf::cut {

/// Makes one group of pieces take a step to the commanded blade, wait, or refuse the step. `group`:
/// one of the stroke, with its rung at its present position.
CutResult takeStep(CutBody& body, Stroke& stroke, GroupStroke& group, Gate gate);

}  // namespace kerf::cut

#pragma once

#include "sim/cut/stroke/stroke.h"

namespace kerf::cut {

/// Lets one group of pieces take a step to where the blade was told to go, wait, or refuse the
/// step. `group`: one of the stroke, with its rung where that lies now.
CutResult takeStep(CutBody& body, Stroke& stroke, GroupStroke& group, Gate gate);

}  // namespace kerf::cut

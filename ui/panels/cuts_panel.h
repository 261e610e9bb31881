#pragma once

#include "ui/state/cuts_state.h"

namespace kerf::ui {

/// Draws the quality of the cuts: the figures of all of them beside those of the last stroke.
void drawCuts(const CutsState& cuts);

}  // namespace kerf::ui

#pragma once

#include "ui/state/cuts_state.h"

namespace kerf::ui {

/// Draws how well the cuts came out: the figures of all of them beside those of the last stroke.
void drawCuts(const CutsState& cuts);

}  // namespace kerf::ui

#pragma once

#include <vector>

#include "ui/state/action.h"
#include "ui/state/body_state.h"

namespace kerf::ui {

/// Draws the boxes that the body collides with, one foldable group each, and a button for another
/// one.
void drawBoxes(const BodyState& body, std::vector<Action>& actions);

}  // namespace kerf::ui

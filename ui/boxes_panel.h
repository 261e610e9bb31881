#pragma once

#include <vector>

#include "ui/action.h"
#include "ui/panel_model.h"

namespace kerf::ui {

/// Draws the boxes that the body collides with, one foldable group each, and a button for another
/// one.
void drawBoxes(const PanelModel& model, std::vector<Action>& actions);

}  // namespace kerf::ui

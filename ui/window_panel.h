#pragma once

#include <vector>

#include "ui/action.h"
#include "ui/panel_model.h"

namespace kerf::ui {

/// Draws the choosers of the window's theme and scale.
void drawWindowRows(const PanelModel& model, std::vector<Action>& actions);

}  // namespace kerf::ui

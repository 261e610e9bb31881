#pragma once

#include <vector>

#include "ui/state/action.h"

namespace kerf::ui {

struct PanelModel;

/// Draws the buttons of the tools and the settings of the one that is chosen.
void drawTools(const PanelModel& model, std::vector<Action>& actions);

}  // namespace kerf::ui

#pragma once

#include <vector>

#include "ui/action.h"
#include "ui/panel_model.h"

namespace kerf::ui {

/// Draws a card for each of the paper's experiments, its figures beside ours; a click opens it.
void drawExperiments(const PanelModel& model, std::vector<Action>& actions);

}  // namespace kerf::ui

#pragma once

#include <vector>

#include "ui/action.h"
#include "ui/panel_model.h"
#include "ui/plot.h"

namespace kerf::ui {

/// The plots that are chosen in the settings. What they point to lives as long as the model.
std::vector<PlotSpec> chosenPlots(const PanelModel& model);

/// Draws a line of buttons and the chosen plots, together `height` pixels high; they scroll where
/// they would get too small to read.
void drawPlots(const PanelModel& model, float height, std::vector<Action>& actions);

}  // namespace kerf::ui

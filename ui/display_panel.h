#pragma once

#include <vector>

#include "ui/action.h"
#include "ui/panel_model.h"

namespace kerf::ui {

/// What is drawn over the body, how finely, and its colours.
void drawDisplay(const PanelModel& model, std::vector<Action>& actions);

/// What the colours of the overlays mean, at the right of the view, while any is shown.
void drawLegend(const DisplaySettings& display, const Rect& view, float scale);

}  // namespace kerf::ui

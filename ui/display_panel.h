#pragma once

#include <vector>

#include "ui/action.h"
#include "ui/panel_model.h"

namespace kerf::ui {

/// Draws the switches of all that is drawn over the body, and the choosers of its colours.
void drawDisplay(const PanelModel& model, std::vector<Action>& actions);

/// Draws the meaning of the colours of the overlays, and of the body where they show a quantity, at
/// the right of the view, while any is shown.
void drawLegend(const PanelModel& model, const Rect& view, float scale);

}  // namespace kerf::ui

#pragma once

#include <vector>

#include "ui/base/layout.h"
#include "ui/state/action.h"
#include "ui/state/looks_state.h"

namespace kerf::ui {

struct PanelModel;

/// Draws the switches of all that is drawn over the body, and the choosers of its colours.
void drawDisplay(const PanelModel& model, std::vector<Action>& actions);

/// Draws the meaning of the colours of the overlays, and of the body where they show a quantity, at
/// the right of the view, while any is shown.
void drawLegend(const LooksState& looks, const DisplaySettings& display, const Rect& view,
                float scale);

}  // namespace kerf::ui

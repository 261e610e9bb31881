#pragma once

#include <vector>

#include "ui/base/layout.h"
#include "ui/state/action.h"
#include "ui/state/looks_state.h"

namespace kerf::ui {

struct PanelModel;

/// Draws the toggles of the overlays, and the choosers of the body's colours.
void drawDisplay(const PanelModel& model, std::vector<Action>& actions);

/// Draws a legend of the colours of overlays, and of a quantity on the body, at the right of the
/// view, while any is shown.
void drawLegend(const LooksState& looks, const DisplaySettings& display, const Rect& view,
                float scale);

}  // namespace kerf::ui

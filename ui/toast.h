#pragma once

#include "ui/layout.h"
#include "ui/panel_model.h"

namespace kerf::ui {

/// Draws what just happened at the upper edge of the view. It takes no input and fades by itself.
void drawToast(const PanelModel& model, const Rect& view);

}  // namespace kerf::ui

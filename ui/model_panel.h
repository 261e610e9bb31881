#pragma once

#include <vector>

#include "ui/action.h"
#include "ui/panel_model.h"

namespace kerf::ui {

/// Draws what the open model is in the scene: its unit, up axis, turn and scale, which a click or a
/// drag changes, and what physics makes of its size.
void drawModel(const PanelModel& model, std::vector<Action>& actions);

}  // namespace kerf::ui

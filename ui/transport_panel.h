#pragma once

#include <vector>

#include "ui/action.h"
#include "ui/panel_model.h"

namespace kerf::ui {

/// Draws the buttons that play, pause, step, reset and record, and the simulated time.
void drawTransport(const PanelModel& model, std::vector<Action>& actions);

}  // namespace kerf::ui

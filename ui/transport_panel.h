#pragma once

#include <vector>

#include "ui/action.h"
#include "ui/panel_model.h"

namespace kerf::ui {

/// Play or pause, step, reset, and the simulated time.
void drawTransport(const PanelModel& model, std::vector<Action>& actions);

}  // namespace kerf::ui

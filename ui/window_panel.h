#pragma once

#include <vector>

#include "ui/action.h"
#include "ui/panel_model.h"

namespace kerf::ui {

/// How the window itself looks: theme and scale.
void drawWindowRows(const PanelModel& model, std::vector<Action>& actions);

}  // namespace kerf::ui

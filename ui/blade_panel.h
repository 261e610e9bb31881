#pragma once

#include <vector>

#include "ui/action.h"
#include "ui/panel_model.h"

namespace kerf::ui {

/// Which blade, and how deep it goes.
void drawBlade(const PanelModel& model, std::vector<Action>& actions);

}  // namespace kerf::ui

#pragma once

#include <vector>

#include "ui/action.h"
#include "ui/panel_model.h"

namespace kerf::ui {

/// What the left button does, and how deep or how far around.
void drawTools(const PanelModel& model, std::vector<Action>& actions);

}  // namespace kerf::ui

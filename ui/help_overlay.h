#pragma once

#include <vector>

#include "ui/action.h"
#include "ui/panel_model.h"

namespace kerf::ui {

/// Keys and pointer gestures, made from the shortcut table, over all while it is open.
void drawHelp(const PanelModel& model, std::vector<Action>& actions);

}  // namespace kerf::ui

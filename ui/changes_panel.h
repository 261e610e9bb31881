#pragma once

#include <vector>

#include "ui/action.h"
#include "ui/panel_model.h"

namespace kerf::ui {

/// What was changed, oldest first, and how much memory its undo takes; a click goes there.
void drawChanges(const PanelModel& model, std::vector<Action>& actions);

}  // namespace kerf::ui

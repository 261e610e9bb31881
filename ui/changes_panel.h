#pragma once

#include <vector>

#include "ui/action.h"
#include "ui/panel_model.h"

namespace kerf::ui {

/// Draws the list of changes, oldest first, and the memory that their undo takes. A click goes to
/// that change.
void drawChanges(const PanelModel& model, std::vector<Action>& actions);

}  // namespace kerf::ui

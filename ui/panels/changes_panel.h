#pragma once

#include <vector>

#include "ui/state/action.h"
#include "ui/state/change_list.h"

namespace kerf::ui {

struct PanelModel;

/// Draws the list of changes, oldest first, and the memory that their undo takes. A click goes to
/// that change.
void drawChanges(const PanelModel& model, std::vector<Action>& actions);

}  // namespace kerf::ui

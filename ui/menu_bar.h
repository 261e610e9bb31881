#pragma once

#include <vector>

#include "ui/action.h"
#include "ui/panel_model.h"

namespace kerf::ui {

/// A menu per group of the shortcut table, in the menu bar of the panel that is being drawn.
void drawMenuBar(const PanelModel& model, std::vector<Action>& actions);

/// Whether an action would do something now.
bool isAvailable(const PanelModel& model, ActionId id);
/// Whether what an action switches is on.
bool isOn(const PanelModel& model, ActionId id);

}  // namespace kerf::ui

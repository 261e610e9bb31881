#pragma once

#include <vector>

#include "ui/state/action.h"

namespace kerf::ui {

struct PanelModel;

/// Draws a menu per group of the table of actions, in the menu bar of the panel that is being
/// drawn.
void drawMenuBar(const PanelModel& model, std::vector<Action>& actions);

}  // namespace kerf::ui

#pragma once

#include <vector>

#include "ui/state/action.h"

namespace kerf::ui {

/// Draws the choosers of the window's theme and scale.
void drawWindowRows(const Settings& settings, std::vector<Action>& actions);

}  // namespace kerf::ui

#pragma once

#include <vector>

#include "ui/base/layout.h"
#include "ui/state/action.h"
#include "ui/state/help_state.h"

namespace kerf::ui {

struct PanelModel;

/// Draws a hint what to do next into the view: at its lower edge, or in its middle if nothing is
/// open. Only the buttons of its choices take input.
void drawHint(const PanelModel& model, const Rect& view, std::vector<Action>& actions);

/// If no side panel is shown: draws a button with the key that shows them, in place of the menu.
void drawPanelsHint(const Settings& settings, const Rect& view, std::vector<Action>& actions);

}  // namespace kerf::ui

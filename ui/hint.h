#pragma once

#include <vector>

#include "ui/base/layout.h"
#include "ui/state/action.h"
#include "ui/state/help_state.h"

namespace kerf::ui {

struct PanelModel;

/// Draws what to do first or next into the view: at its lower edge, or in its middle while nothing
/// is open. It takes no input but on the buttons of its choices.
void drawHint(const PanelModel& model, const Rect& view, std::vector<Action>& actions);

/// While no side panel is shown: draws a button with the key that brings them back, where the menu
/// was.
void drawPanelsHint(const Settings& settings, const Rect& view, std::vector<Action>& actions);

}  // namespace kerf::ui

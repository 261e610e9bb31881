#pragma once

#include <vector>

#include "ui/state/action.h"
#include "ui/state/session_state.h"

namespace kerf::ui {

/// Draws the rows of the menu that adds pictures, checks and exports to the session.
void drawSessionAdditions(std::vector<Action>& actions);

/// Draws the pictures, exports and checks of the session, each with a button that removes it.
void drawSessionMarks(const SessionPanelState& session, std::vector<Action>& actions);

}  // namespace kerf::ui

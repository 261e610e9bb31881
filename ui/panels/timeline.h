#pragma once

#include <string>
#include <vector>

#include "ui/base/layout.h"
#include "ui/state/action.h"
#include "ui/state/session_state.h"

namespace kerf::ui {

/// Draws the timeline in `rect`: a slider to seek to any step with ticks for strokes and changes,
/// and above it a mark for each picture, export and check.
void drawTimeline(const SessionPanelState& session, const Rect& rect, std::vector<Action>& actions);

/// A mark for display: "Picture ball-120.png".
std::string labelOf(const SessionMark& mark);

}  // namespace kerf::ui

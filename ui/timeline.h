#pragma once

#include <string>
#include <vector>

#include "ui/panel_model.h"

namespace kerf::ui {

/// Draws the time line of a session that is played: a slider to go to any step, and below it a mark
/// for each picture, export and check.
void drawTimeline(const PanelModel& model, std::vector<Action>& actions);

/// A mark as people read it: "Picture ball-120.png".
std::string labelOf(const SessionMark& mark);

}  // namespace kerf::ui

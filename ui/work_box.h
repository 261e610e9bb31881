#pragma once

#include <vector>

#include "ui/base/layout.h"
#include "ui/state/action.h"
#include "ui/state/work_state.h"

namespace kerf::ui {

/// Draws long work, its stage and its time, at the upper edge of the view, with a button to cancel
/// it if possible; nothing if the title is empty.
void drawWork(const WorkState& work, const Rect& view, std::vector<Action>& actions);

}  // namespace kerf::ui

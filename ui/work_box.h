#pragma once

#include <vector>

#include "ui/base/layout.h"
#include "ui/state/action.h"
#include "ui/state/work_state.h"

namespace kerf::ui {

/// Draws the work that takes long, its stage and its time, at the upper edge of the view, with
/// a button to give it up where it may end; nothing where the title is empty.
void drawWork(const WorkState& work, const Rect& view, std::vector<Action>& actions);

}  // namespace kerf::ui

#pragma once

#include <vector>

#include "ui/action.h"
#include "ui/layout.h"
#include "ui/panel_model.h"

namespace kerf::ui {

/// Draws the work that takes long, its stage and its time, with a button to give it up, at the
/// upper edge of the view; nothing where the title is empty.
void drawWork(const WorkState& work, const Rect& view, std::vector<Action>& actions);

}  // namespace kerf::ui

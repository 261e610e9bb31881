#pragma once

#include <vector>

#include "ui/action.h"
#include "ui/layout.h"
#include "ui/panel_model.h"

namespace kerf::ui {

/// Keys and pointer gestures, made from the shortcut table, over the view while it is open.
void drawHelp(const PanelModel& model, const Rect& view, std::vector<Action>& actions);

}  // namespace kerf::ui

#pragma once

#include <vector>

#include "ui/base/layout.h"
#include "ui/state/toast_state.h"

namespace kerf::ui {

/// Draws a message at the upper edge of the view, with a button for a possible action. It fades.
void drawToast(const ToastState& toast, const Rect& view, std::vector<Action>& actions);

}  // namespace kerf::ui

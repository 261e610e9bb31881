#pragma once

#include <vector>

#include "ui/base/layout.h"
#include "ui/state/toast_state.h"

namespace kerf::ui {

/// Draws what just happened at the upper edge of the view, with a button where something can be
/// done about it. It fades by itself.
void drawToast(const ToastState& toast, const Rect& view, std::vector<Action>& actions);

}  // namespace kerf::ui

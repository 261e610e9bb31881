#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/hint.h"
#include "ui/layout.h"

namespace kerf::ui {

/// What just happened, in the view.
struct ToastState {
    std::string text;  ///< empty for none
    bool isError = false;
    float opacity = 1;                 ///< 0 to 1, while it fades
    std::optional<HintChoice> choice;  ///< what can be done about it
};

/// Draws what just happened at the upper edge of the view, with a button where something can be
/// done about it. It fades by itself.
void drawToast(const ToastState& toast, const Rect& view, std::vector<Action>& actions);

}  // namespace kerf::ui

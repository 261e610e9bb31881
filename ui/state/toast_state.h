#pragma once

#include <optional>
#include <string>

#include "ui/state/help_state.h"

namespace kerf::ui {

/// A message in the view.
struct ToastState {
    std::string text;  ///< empty for none
    bool isError = false;
    float opacity = 1;                 ///< 0 to 1, while it fades
    std::optional<HintChoice> choice;  ///< possible action
};

}  // namespace kerf::ui

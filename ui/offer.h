#pragma once

#include <vector>

#include "ui/base/widgets.h"
#include "ui/state/help_state.h"

namespace kerf::ui {

/// Draws a sentence above a row of buttons, in the middle of `view` and down to `bottom` [px]. The
/// buttons are noted as NAME.KEY.
void drawOffer(const char* name, const Hint& hint, const Rect& view, float bottom,
               const BannerStyle& style, std::vector<Action>& actions);

}  // namespace kerf::ui

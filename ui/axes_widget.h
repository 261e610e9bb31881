#pragma once

#include <vector>

#include "ui/base/layout.h"
#include "ui/state/action.h"
#include "ui/state/view_axes.h"

namespace kerf::ui {

/// A small cross of the world's axes in the upper right corner of the view. A click on one of its
/// six ends looks from there. `scale` is the display's
/// (1 = 96 dpi).
void drawAxes(const ViewAxes& axes, const Rect& view, float scale, std::vector<Action>& actions);

}  // namespace kerf::ui

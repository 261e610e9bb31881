#pragma once

#include <optional>
#include <vector>

#include "ui/base/layout.h"
#include "ui/state/action.h"

namespace kerf::ui {

/// Draws the edges between the side panels and the view: a drag sets the width, a drag to the side
/// hides the panel; an arrow shows it again.
void drawEdges(const Settings& settings, const Layout& layout, float scale,
               std::vector<Action>& actions);

/// Draws a bar across the panel that is being drawn, under the last item. While it is dragged it
/// returns its position as a share of `height` below `top` [px], between 0 and 1.
std::optional<double> horizontalSplitter(const char* id, float top, float height);

/// Height of a horizontal splitter, spacing included [px].
float splitterHeight();

}  // namespace kerf::ui

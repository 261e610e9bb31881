#pragma once

#include <optional>
#include <vector>

#include "ui/action.h"
#include "ui/layout.h"
#include "ui/panel_model.h"

namespace kerf::ui {

/// The edges between the side panels and the view: dragged they set the width, dragged to the side
/// they put the panel away; an arrow brings it back.
void drawEdges(const PanelModel& model, const Layout& layout, float scale,
               std::vector<Action>& actions);

/// A bar across the panel that is being drawn, under the last item. While it is dragged: where to,
/// as a share of `height` below `top` [px]; between 0 and 1.
std::optional<double> horizontalSplitter(const char* id, float top, float height);

/// Height of such a bar, spacing included [px].
float splitterHeight();

}  // namespace kerf::ui

#pragma once

#include <vector>

#include "ui/state/action.h"
#include "ui/state/overlay.h"

namespace kerf::ui {

/// Draws what the clicks of the measuring tool tell, and the list of all measures. True where
/// `tools` changed.
bool drawMeasureRows(const std::vector<MeasureRow>& measures, ToolSettings& tools,
                     std::vector<Action>& actions);

}  // namespace kerf::ui

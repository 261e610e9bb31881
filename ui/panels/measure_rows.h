#pragma once

#include <vector>

#include "ui/state/action.h"
#include "ui/state/overlay.h"

namespace kerf::ui {

/// Draws the kind of the measuring tool, and the list of measurements. Returns whether `tools`
/// changed.
bool drawMeasureRows(const std::vector<MeasureRow>& measures, ToolSettings& tools,
                     std::vector<Action>& actions);

}  // namespace kerf::ui

#pragma once

#include "ui/panel_model.h"

namespace kerf::ui {

/// Frames per second and volume against simulated time, together `height` pixels high.
void drawPlots(const PanelModel& model, float height);

}  // namespace kerf::ui

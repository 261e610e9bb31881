#pragma once

#include "ui/panel_model.h"

namespace kerf::ui {

/// Frames per second and volume against simulated time, and the times of the stages.
void drawPlots(const PanelModel& model);

}  // namespace kerf::ui

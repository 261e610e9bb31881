#pragma once

#include "ui/panel_model.h"

namespace kerf::ui {

/// Draws the time by stage: last, mean, smallest, largest, and the share of all stages, as in the
/// paper's table 3.
void drawStages(const PanelModel& model);

}  // namespace kerf::ui

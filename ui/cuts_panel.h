#pragma once

#include "ui/panel_model.h"

namespace kerf::ui {

/// Draws how well the cuts came out: the figures of all of them beside those of the last stroke.
void drawCuts(const PanelModel& model);

}  // namespace kerf::ui

#pragma once

#include "ui/panel_model.h"

namespace kerf::ui {

/// Draws the sentences that were shown so far, the newest at the bottom and in sight.
void drawLog(const PanelModel& model);

}  // namespace kerf::ui

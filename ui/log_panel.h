#pragma once

#include "ui/panel_model.h"

namespace kerf::ui {

/// What was said so far, newest at the bottom and in sight.
void drawLog(const PanelModel& model);

}  // namespace kerf::ui

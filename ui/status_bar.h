#pragma once

#include "ui/layout.h"
#include "ui/panel_model.h"

namespace kerf::ui {

/// One line: what is open, its size, whether time runs, what draws, where the help is.
void drawStatusBar(const PanelModel& model, const Rect& rect);

}  // namespace kerf::ui

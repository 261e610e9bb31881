#pragma once

#include <string>

#include "ui/layout.h"
#include "ui/panel_model.h"

namespace kerf::ui {

/// What is open, its size, how often pieces were lost, whether time runs.
std::string statusText(const PanelModel& model);

/// One line: what is open, its size, whether time runs, what draws, where the help is.
void drawStatusBar(const PanelModel& model, const Rect& rect);

}  // namespace kerf::ui

#pragma once

#include <string>

#include "ui/base/layout.h"

namespace kerf::ui {

struct PanelModel;

/// A line about the document: its name, its size, how often pieces were lost, whether time runs.
std::string statusText(const PanelModel& model);

/// Draws one line: statusText(), and at its right the device that draws and the key of the help.
void drawStatusBar(const PanelModel& model, const Rect& rect);

}  // namespace kerf::ui

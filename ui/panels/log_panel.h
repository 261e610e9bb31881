#pragma once

#include <vector>

#include "ui/state/log_line.h"

namespace kerf::ui {

/// Draws the messages so far, scrolled to the newest at the bottom.
void drawLog(const std::vector<LogLine>& log);

}  // namespace kerf::ui

#pragma once

#include <vector>

#include "ui/state/log_line.h"

namespace kerf::ui {

/// Draws the sentences that were shown so far, the newest at the bottom and in sight.
void drawLog(const std::vector<LogLine>& log);

}  // namespace kerf::ui

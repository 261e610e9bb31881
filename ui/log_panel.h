#pragma once

#include <string>
#include <vector>

namespace kerf::ui {

/// One line of the log.
struct LogLine {
    std::string text;
    bool isError = false;
};

/// Draws the sentences that were shown so far, the newest at the bottom and in sight.
void drawLog(const std::vector<LogLine>& log);

}  // namespace kerf::ui

#pragma once

#include <string>

namespace kerf::ui {

/// One line of the log.
struct LogLine {
    std::string text;
    bool isError = false;
};

}  // namespace kerf::ui

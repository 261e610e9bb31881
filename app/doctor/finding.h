#pragma once

#include <string>

namespace kerf::app {

/// What one check of a driver found.
struct DriverFinding {
    std::string check;  ///< "Free fall"
    std::string seen;   ///< what was measured, with its unit
    std::string asked;  ///< what a driver that works gives
    bool right = false;
};

}  // namespace kerf::app

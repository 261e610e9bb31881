#pragma once

#include "app/doctor/findings.h"

namespace kerf::app {

/// A line about each finding that is wrong.
inline std::vector<std::string> wrongOnes(const std::vector<DriverFinding>& findings) {
    std::vector<std::string> wrong;
    for (const DriverFinding& finding : findings) {
        if (!finding.right) {
            wrong.push_back(finding.check + ": " + finding.seen + ", asked " + finding.asked);
        }
    }
    return wrong;
}

}  // namespace kerf::app

#pragma once

#include <string>
#include <vector>

#include "app/regression/test_result.h"

namespace kerf::app {

/// The results as one HTML page that needs no other file: each picture expected, as it is, and the
/// difference, with a slider between them, and plots of what deviates. Throws InputError where the
/// page's template or a picture can't be read.
std::string formatTestReport(const std::vector<TestResult>& results);

}  // namespace kerf::app

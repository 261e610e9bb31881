#pragma once

#include <string>
#include <vector>

#include "app/regression/test_result.h"

namespace kerf::app {

/// The results as a self-contained HTML page: each picture expected, actual, and the difference,
/// with a slider between them, and plots of deviations. Throws InputError if the page's template or
/// a picture can't be read.
std::string formatTestReport(const std::vector<TestResult>& results);

}  // namespace kerf::app

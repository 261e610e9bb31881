#pragma once

#include "app/regression/judgement.h"

namespace kerf::app {

/// Makes or renews the expectation in a folder from a run: the tables, the pictures, and
/// expected.json last. Keeps masks, limits and tolerances of an earlier expectation; removes
/// pictures that the session does not take. Throws OutputError, and InputError if the earlier one
/// can't be read.
void writeExpectation(const std::filesystem::path& expectationFolder, const RunResults& results);

}  // namespace kerf::app

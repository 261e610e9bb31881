#pragma once

#include "tests/support/fuzz/fuzz_target.h"

namespace kerf::test {

/// The outcome where bytes were refused with this sentence: broken where it is none, is longer than
/// anybody reads, or holds what would steer a terminal.
FuzzOutcome refusedWith(const std::string& sentence);
/// The same for a clause, to which others add the name of the file and the full stop.
FuzzOutcome refusedWithClause(const std::string& clause);

}  // namespace kerf::test

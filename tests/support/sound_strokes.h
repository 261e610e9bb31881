#pragma once

#include <gtest/gtest.h>

#include "tests/support/cut_fuzz.h"

namespace kerf::test {

/// Runs a seed of the fuzz and expects valid meshes, no refusals, and pieces that came apart.
/// Returns what happened by setting, for what else is to be expected.
inline std::vector<FuzzFigures> expectSoundStrokes(std::uint64_t seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    FuzzReport report;
    fuzzOnce(seed, report);
    std::vector<FuzzFigures> totals;
    for (const FuzzSetting setting : kFuzzSettings) {
        totals.push_back(report.total(setting));
        EXPECT_EQ(totals.back().invalid, 0);
        EXPECT_EQ(totals.back().refused, 0);
        EXPECT_EQ(totals.back().unseparated, 0);
    }
    return totals;
}

}  // namespace kerf::test

// What tests leave for the night: scripts/nightly.
#pragma once

#include <cstdlib>

namespace kerf::test {

/// Whether what takes long and rarely finds anything is to run too: KERF_NIGHTLY is set.
inline bool nightly() {
    return std::getenv("KERF_NIGHTLY") != nullptr;
}

/// The number that a variable of the environment has, or `otherwise` where it is not set.
inline double environmentNumber(const char* variable, double otherwise) {
    const char* const text = std::getenv(variable);
    return text == nullptr ? otherwise : std::atof(text);
}

/// How many random runs a test makes: as the variable says, else by day or by night.
inline int runs(const char* variable, int byDay, int byNight) {
    return static_cast<int>(environmentNumber(variable, nightly() ? byNight : byDay));
}

}  // namespace kerf::test

/// Leaves the rest of a test, whose faults others find too, for the night.
#define KERF_BY_NIGHT()                                  \
    if (!kerf::test::nightly()) {                        \
        GTEST_SKIP() << "run at night: scripts/nightly"; \
    }

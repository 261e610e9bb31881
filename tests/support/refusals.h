// What is refused, and why.
#pragma once

#include <gmock/gmock.h>

#include "app/files/io/errors.h"
#include "tests/support/run_kerf.h"

namespace kerf::test {

/// The sentence that `act` throws as app::InputError; empty where it throws nothing.
template <class Act>
std::string inputErrorOf(Act&& act) {
    try {
        act();
    } catch (const app::InputError& error) {
        return error.what();
    }
    return "";
}

/// That a run ended with an exit code and these words on standard error.
inline void expectEnd(const ProgramRun& run, int exitCode, const std::string& words) {
    EXPECT_EQ(run.exitCode, exitCode) << run.errors;
    EXPECT_THAT(run.errors, testing::HasSubstr(words));
}

}  // namespace kerf::test

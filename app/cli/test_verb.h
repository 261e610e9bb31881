#pragma once

#include <filesystem>
#include <iosfwd>
#include <vector>

namespace kerf::app {

/// The arguments of `kerf test PATH... [--update] ...`, parsed.
struct TestArguments {
    std::vector<std::filesystem::path> paths;
    bool update = false;
    int jobs = 0;                  ///< 0: one per core
    std::filesystem::path junit;   ///< empty for none
    std::filesystem::path report;  ///< empty for none
    std::filesystem::path out;     ///< keeps the results of the runs; empty for nowhere
    bool json = false;
};

/// Runs sessions as regression tests and prints what came of them on `out`. Returns the exit code:
/// 0, 1 where one differs or was not run, 3 where one can't be read, 5 where its expectation can't
/// be written. Throws InputError, OutputError, gpu::ContextError.
int testVerb(const TestArguments& arguments, std::ostream& out);

}  // namespace kerf::app

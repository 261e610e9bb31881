#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>

namespace kerf::app {

/// The arguments of `kerf sweep STUDY --out DIR ...`, parsed.
struct SweepArguments {
    std::filesystem::path study;
    std::filesystem::path out;       ///< empty for none, which --list alone may do without
    int jobs = 0;                    ///< 0: one per core
    std::optional<std::size_t> run;  ///< this run alone
    bool list = false;               ///< says what the runs are, and runs nothing
    bool gather = false;             ///< gathers what is there, and runs nothing
    bool json = false;
};

/// Does the runs of a study that are not done yet, gathers their results, and prints what came of
/// them on `out`; what a single run says goes to `errors`. Returns the exit code: 0, 1 where a run
/// failed or is missing, or that of the single run. Throws InputError, OutputError, UsageError and
/// gpu::ContextError.
int sweepVerb(const SweepArguments& arguments, std::ostream& out, std::ostream& errors);

}  // namespace kerf::app

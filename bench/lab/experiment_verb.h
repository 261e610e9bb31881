#pragma once

#include <filesystem>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>

namespace kerf::app {

/// The arguments of `kerf experiment NAME|all --out DIR [--published] [--runs N] [--json]`, parsed.
struct ExperimentArguments {
    std::string name;  ///< of an experiment, or "all"
    /// With the paper's solver, contact and course of the cut; of the paper's experiments alone.
    bool published = false;
    int runs = 5;        ///< of each stroke, for the spread of frame rates; likewise
    bool whole = false;  ///< all combinations of settings; of "bar" alone
    std::filesystem::path out;
    bool json = false;
};

/// An experiment of Kerf's own, which "all" leaves out: it has a folder of its name.
struct OwnExperiment {
    const char* name;
    int (*run)(const ExperimentArguments& arguments, std::ostream& out, std::ostream& errors);
};
std::span<const OwnExperiment> ownExperiments();
/// Null where there is none of that name.
const OwnExperiment* findOwnExperiment(std::string_view name);

/// Runs the paper's experiment of that name, or all of them, from the sessions in assets/sessions:
/// each writes into DIR/NAME what a replay writes and a plot of volume and frames, and repeats its
/// stroke for the spread of frame rates. The figures go into DIR/figures, and DIR/report.md comes
/// last. Prints the volumes beside the paper's on `out`; the first failed check
/// goes to `errors`. Returns the exit code, 0 or 1. Throws what replaySession throws, and
/// gpu::ContextError. One of ownExperiments() is run instead where it has that name.
int experimentVerb(const ExperimentArguments& arguments, std::ostream& out, std::ostream& errors);

}  // namespace kerf::app

#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

namespace kerf::app {

/// The arguments of `kerf experiment NAME|all --out DIR [--published] [--runs N] [--json]`, parsed.
struct ExperimentArguments {
    std::string name;        ///< of an experiment, "bar" or "all"
    bool published = false;  ///< with the paper's solver, contact and course of the cut; not "bar"
    int runs = 5;            ///< of each stroke, for the spread of frame rates; not "bar"
    bool whole = false;      ///< all combinations of settings; "bar" alone
    std::filesystem::path out;
    bool json = false;
};

/// Runs the paper's experiment of that name, or all of them, from the sessions in assets/sessions:
/// each writes into DIR/NAME what a replay writes and a plot of volume and frames, and repeats its
/// stroke for the spread of frame rates. The figures go into DIR/figures, and DIR/report.md comes
/// last. Prints the volumes beside the paper's on `out`; the first failed check
/// goes to `errors`. Returns the exit code, 0 or 1. Throws what replaySession throws, and
/// gpu::ContextError. "bar" is the test bench instead, which "all" leaves out: runBarExperiment.
int experimentVerb(const ExperimentArguments& arguments, std::ostream& out, std::ostream& errors);

}  // namespace kerf::app

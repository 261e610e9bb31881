#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "app/cli/bar_rig.h"

namespace kerf::app {

/// Name of the experiment, and of its folder.
inline constexpr const char* kConvergenceExperiment = "convergence";

/// How far a swinging specimen is from where much smaller substeps have it.
struct ConvergenceRun {
    BenchSetting setting;
    /// RMS of the distance of all vertices, over that of their ways since rest.
    double error = 0;
    bool tooFewIterations = false;  ///< the program says so: hasTooFewSweeps()

    /// Length of a substep [s].
    double substep() const { return setting.timeStep / setting.iterations; }
};

/// The runs of one specimen, by time step and then iterations.
struct Convergence {
    BenchSetting reference;  ///< with the smallest substeps
    double seconds = 0;      ///< after which errors are taken
    std::vector<ConvergenceRun> runs;

    /// The exponent p of the line error = c h^p that fits the logarithms best over the substeps h
    /// up to four times the shortest: an order is what errors do where substeps are short. Without
    /// runs of which the program says that iterations are too few; 0 where there are not two.
    double order() const;
};

/// Measures the errors of a specimen with each of the iterations and time steps against the
/// reference; it is what `reference` says in all else. Runs on the GL context that is current.
Convergence measureConvergence(const BenchSetting& reference, double seconds,
                               const std::vector<double>& timeSteps,
                               const std::vector<int>& iterations);

/// The text of report.md: a table of errors for each specimen, and the order.
std::string formatConvergenceReport(const std::vector<Convergence>& all);

/// Runs `kerf experiment convergence`: a bar that hangs and one that bends, both with
/// `true_modulus` (see measureConvergence). Writes report.md and summary.json into DIR/convergence;
/// prints the report, or with `json` the summary. Returns 0, or 1 where an order is below 0.9.
/// Throws OutputError, gpu::ContextError.
int runConvergenceExperiment(const std::filesystem::path& folder, bool json, std::ostream& out,
                             std::ostream& errors);

}  // namespace kerf::app

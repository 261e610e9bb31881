#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "app/files/io/output_folder.h"
#include "bench/lab/bar_rig.h"

namespace kerf::app {

/// Name of the experiment, and of its folder.
inline constexpr const char* kBarExperiment = "bar";

/// A test that was run.
struct BenchRun {
    BenchSetting setting;
    BenchResult result;
};

/// The text of report.md: the effective modulus over the parameter, by resolution and iterations.
std::string formatBarReport(const std::vector<BenchRun>& runs);

/// One sentence that names all specimens that did not settle; empty where all did.
std::string stillMovingWarning(const std::vector<BenchRun>& runs);

/// How far a bar that comes down was from where it should be.
struct AccuracyRun {
    int iterations = 0;
    double timeStep = 0;  ///< [s]
    double error = 0;     ///< the largest, as a share of how far it comes down
};

/// Lets a hanging bar with `true_modulus` come down by these iterations of these time steps, and
/// with substeps a quarter as long as the shortest of them, by which they are judged. Runs on the
/// GL context that is current.
std::vector<AccuracyRun> measureAccuracy(const std::vector<int>& iterations,
                                         const std::vector<double>& timeSteps);

/// The order of convergence in the length of a substep: the slope of the error in logarithms, by
/// least squares. Of runs with at least two lengths.
double orderOf(const std::vector<AccuracyRun>& runs);

/// A table of them for report.md, with the order.
std::string formatAccuracy(const std::vector<AccuracyRun>& runs);

/// Writes report.md and summary.json into `folder`; prints the report, or with `json` the summary.
/// Specimens that did not settle are named in one warning. Returns 0, or 1 where a specimen lost
/// volume. Throws OutputError.
int reportBarRuns(const std::vector<BenchRun>& runs, const std::vector<AccuracyRun>& accuracy,
                  OutputFolder& folder, bool json, std::ostream& out, std::ostream& errors);

/// How many of these runs are that near to the modulus.
struct BarCount {
    int all = 0;
    int within10 = 0;  ///< per cent
    int within25 = 0;
};

/// Counts the runs with `true_modulus` or without, of which the program does not say that
/// iterations are too few, or of which it does.
BarCount countBarRuns(const std::vector<BenchRun>& runs, bool trueModulus, bool tooFewIterations);

/// The settings of `kerf experiment bar`, each once: each specimen with and without `true_modulus`
/// at three moduli by resolution, by number of iterations and by time step. `whole`: all
/// combinations of the three.
std::vector<BenchSetting> barSettings(bool whole);

/// Runs `kerf experiment bar`: all of barSettings() (see measureModulus), reported by reportBarRuns
/// in DIR/bar. Throws OutputError, gpu::ContextError.
int runBarExperiment(const std::filesystem::path& folder, bool whole, bool json, std::ostream& out,
                     std::ostream& errors);

}  // namespace kerf::app

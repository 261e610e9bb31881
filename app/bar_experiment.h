#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "app/test_bench.h"

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

/// `kerf experiment bar`: a hanging bar and a compressed block (see measureModulus) at four
/// resolutions, three moduli and five numbers of iterations. Writes DIR/bar/summary.json and
/// DIR/bar/report.md; prints the report, or with `json` the summary. Returns 0, or 1 where a
/// specimen did not settle or lost volume. Throws OutputError, gpu::ContextError.
int runBarExperiment(const std::filesystem::path& folder, bool json, std::ostream& out,
                     std::ostream& errors);

}  // namespace kerf::app

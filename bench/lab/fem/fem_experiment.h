#pragma once

#include <filesystem>
#include <iosfwd>
#include <span>
#include <vector>

#include "bench/lab/fem/fem_report.h"

namespace kerf::app {

/// Name of the experiment, and of its folder.
inline constexpr const char* kFemExperiment = "fem";

/// What Kerf runs the cases with: its defaults, and as many iterations as there can be.
std::span<const FemSetting> femSettings();

/// Runs these cases with each of these settings, the finite elements of each once, and leaves
/// models, sessions and pictures in the folder. Needs a current OpenGL 4.5 context. Throws
/// InputError, OutputError.
std::vector<FemResult> runFemCases(const std::vector<FemCase>& cases,
                                   std::span<const FemSetting> settings, OutputFolder& folder);

/// Runs `kerf experiment fem`: bodies that are cut, held and loaded, Kerf's beside finite elements.
/// Writes report.md, summary.json, sessions and pictures into DIR/fem, and prints the report, or
/// with `json` the summary. Returns 0: what is beyond a bar is a figure, and no failure. Throws
/// InputError, OutputError, gpu::ContextError.
int runFemExperiment(const std::filesystem::path& folder, bool json, std::ostream& out);

}  // namespace kerf::app

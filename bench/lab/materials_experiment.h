#pragma once

#include <filesystem>
#include <iosfwd>

namespace kerf::app {

/// Name of the experiment, and of its folder.
inline constexpr const char* kMaterialsExperiment = "materials";

/// Runs `kerf experiment materials`: drops, presses, cuts and pulls open a ball of 10 cm of each
/// material that comes with Kerf (assets/sessions/material.kerf.json). Writes what a replay writes
/// into DIR/materials/NAME, a row of pictures of each as strip.png there, and all rows as
/// DIR/materials/materials.png. Prints its path, or with `json` a summary of each run. Returns 0,
/// or 1 where a check of a run failed. Throws what replaySession throws, and gpu::ContextError.
int runMaterialsExperiment(const std::filesystem::path& folder, bool json, std::ostream& out,
                           std::ostream& errors);

}  // namespace kerf::app

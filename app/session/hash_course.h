#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/run/state_hash.h"

namespace kerf::app {

/// First line of hashes.csv and its rows, each with its line break. A row tells the state after a
/// step.
std::string hashesHeader();
std::string formatHashes(int step, const StateHashes& hashes);

/// The hashes of each step of an earlier run, read from its hashes.csv.
class HashCourse {
  public:
    /// Reads a file. Besides `step`, `state_hash` and `topology_hash` the columns may be missing;
    /// unknown ones are passed over. Throws InputError naming file and line.
    static HashCourse read(const std::filesystem::path& file);

    /// Number of steps in the file.
    int steps() const { return static_cast<int>(rows_.size()); }
    /// State hash after a step below steps().
    const std::string& stateHash(int step) const {
        return rows_[static_cast<std::size_t>(step)].state;
    }
    /// Compares the state after a step. Returns the names of the parts that are not as the file has
    /// them; none where all that it holds agrees. `step` is below steps().
    std::vector<std::string> differingParts(int step, const StateHashes& hashes) const;
    /// Compares a step with that of another file.
    std::vector<std::string> differingParts(int step, const HashCourse& other) const;

  private:
    std::vector<StateHashes> rows_;  ///< by step; what a file does not hold is empty
};

}  // namespace kerf::app

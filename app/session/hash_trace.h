#pragma once

#include "sim/run/state_hash.h"

namespace kerf::app {

/// First line of hashes.csv and its rows, each with its line break. A row has the state after a
/// step.
std::string hashesHeader();
std::string formatHashes(int step, const StateHashes& hashes);

/// The hashes of each step of an earlier run, read from its hashes.csv.
class HashTrace {
  public:
    /// Reads a file. All columns except `step`, `state_hash` and `topology_hash` are optional;
    /// unknown ones are ignored. Throws InputError naming file and line.
    static HashTrace read(const std::filesystem::path& file);

    /// Number of steps in the file.
    int steps() const { return static_cast<int>(rows_.size()); }
    /// State hash after a step below steps().
    const std::string& stateHash(int step) const {
        return rows_[static_cast<std::size_t>(step)].state;
    }
    /// Compares the state after a step. Returns the names of the parts that differ from the file.
    /// `step` is below steps().
    std::vector<std::string> differingParts(int step, const StateHashes& hashes) const;
    /// Compares a step with that of another file.
    std::vector<std::string> differingParts(int step, const HashTrace& other) const;

  private:
    std::vector<StateHashes> rows_;  ///< by step; missing values are empty
};

}  // namespace kerf::app

#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace kerf::gpu {

/// Linked programs as the driver writes them, in files of a folder, so that a start need not
/// compile what an earlier one has. A file is named by the sources, the driver and this program's
/// version. What is damaged, or what the driver does not take, is passed over.
class ProgramBinaries {
  public:
    /// Keeps nothing.
    ProgramBinaries() = default;
    /// Files go into `folder`, which is made. Needs a current context. Keeps nothing where its
    /// driver has no such binaries.
    ProgramBinaries(std::filesystem::path folder, const std::string& version);

    /// Fills a program, new and without shaders, with what was saved for these sources. False where
    /// nothing was, and the program is as it was.
    bool load(std::uint32_t program, const std::string& sources) const;
    /// Saves a linked program; where that fails nothing is saved.
    void save(std::uint32_t program, const std::string& sources) const;

    /// The cache that Program uses: none at first.
    static ProgramBinaries& ours();

  private:
    std::filesystem::path fileOf(const std::string& sources) const;

    std::filesystem::path folder_;  ///< empty: keeps nothing
    std::string maker_;             ///< the driver and the version
};

/// $XDG_CACHE_HOME/kerf/programs, by default in ~/.cache; empty where there is no home.
std::filesystem::path programBinariesFolder();

}  // namespace kerf::gpu

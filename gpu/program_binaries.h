#pragma once

namespace kerf::gpu {

/// A cache of the driver's program binaries in files of a folder, so that a start need not
/// recompile. A file is named by the sources, the driver and this program's version. Damaged or
/// rejected files are ignored.
class ProgramBinaries {
  public:
    /// Keeps nothing.
    ProgramBinaries() = default;
    /// Files go into `folder`, which is made. Needs a current context. Keeps nothing if its driver
    /// has no such binaries.
    ProgramBinaries(std::filesystem::path folder, const std::string& version);

    /// Loads a new program without shaders from what was saved for these sources. False if there is
    /// nothing, with the program unchanged.
    bool load(std::uint32_t program, const std::string& sources) const;
    /// Saves a linked program; ignores failures.
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

#pragma once

#include <filesystem>
#include <vector>

namespace kerf::app {

/// Files that were opened or saved, the last one first, kept in a text file, a path a line.
class RecentFiles {
  public:
    static constexpr std::size_t kMost = 12;

    /// Reads `store`; empty keeps nothing beyond this run. What can't be read counts as empty.
    explicit RecentFiles(std::filesystem::path store);

    /// Puts a file first and writes the store. A store that can't be written is ignored: the list
    /// is a convenience.
    void add(const std::filesystem::path& file);

    /// The files that existed at the last check: when one was added, or by look().
    const std::vector<std::filesystem::path>& files() const { return there_; }
    /// Checks which of the files exist.
    void look();
    /// The folders of files(), each once.
    std::vector<std::filesystem::path> folders() const;

  private:
    void write() const;

    std::filesystem::path store_;
    std::vector<std::filesystem::path> files_;
    std::vector<std::filesystem::path> there_;
};

/// $XDG_STATE_HOME/kerf/recent-files, by default below ~/.local/state; empty without a home.
std::filesystem::path recentFilesStore();

}  // namespace kerf::app

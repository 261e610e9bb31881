#pragma once

#include "ui/base/settings.h"

namespace kerf::app {

/// The settings in a file: JSON with a key per setting (docs/editor.md). If it can't be read, the
/// defaults apply, and the file is unchanged until a setting changes.
class SettingsFile {
  public:
    /// Reads the settings of `file`. An empty path reads and writes nothing.
    explicit SettingsFile(std::filesystem::path file);

    /// Writes changed settings. Returns "" or one sentence.
    std::string save();
    /// The problem with the file when it was read: one sentence, or "".
    const std::string& problem() const { return problem_; }

    /// Empty: nothing is read or written.
    const std::filesystem::path& file() const { return file_; }

    ui::Settings now;

  private:
    std::filesystem::path file_;
    ui::Settings saved_;
    std::string problem_;
};

/// $XDG_CONFIG_HOME/kerf/settings.json, by default in ~/.config; empty without a home.
std::filesystem::path defaultSettingsFile();

/// Text of a settings file, and back. Missing keys have their defaults, unknown keys are ignored.
/// Throws InputError with the key and what is wrong with its value.
std::string formatSettings(const ui::Settings& settings);
ui::Settings parseSettings(const std::string& text);

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

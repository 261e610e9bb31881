#pragma once

#include <filesystem>
#include <string>

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

}  // namespace kerf::app

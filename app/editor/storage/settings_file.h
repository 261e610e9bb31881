#pragma once

#include <filesystem>
#include <string>

#include "ui/base/settings.h"

namespace kerf::app {

/// The settings in a file: JSON with a key per setting (docs/editor.md). What cannot be read leaves
/// the defaults, and the file as it is until a setting is changed.
class SettingsFile {
  public:
    /// Reads the settings of `file`. An empty path reads and writes nothing.
    explicit SettingsFile(std::filesystem::path file);

    /// Writes the settings where they have changed. Returns "" or one sentence.
    std::string save();
    /// The problem with the file when it was read: one sentence, or "".
    const std::string& problem() const { return problem_; }

    ui::Settings now;

  private:
    std::filesystem::path file_;
    ui::Settings saved_;
    std::string problem_;
};

/// $XDG_CONFIG_HOME/kerf/settings.json, by default in ~/.config; empty where there is no home.
std::filesystem::path defaultSettingsFile();

/// Text of a settings file, and back. Keys that it lacks have their defaults, keys that are unknown
/// are passed over. Throws InputError with the key and what is wrong with its value.
std::string formatSettings(const ui::Settings& settings);
ui::Settings parseSettings(const std::string& text);

}  // namespace kerf::app

#pragma once

#include <filesystem>

namespace kerf::app {

/// Kerf's folder in one of the XDG base directories: `variable`, if an absolute path, else `usual`
/// in the home folder; empty without a home.
std::filesystem::path baseFolder(const char* variable, const char* usual);
/// The folder of Kerf's state: $XDG_STATE_HOME/kerf, by default in ~/.local/state; empty without a
/// home.
std::filesystem::path stateFolder();

}  // namespace kerf::app

#pragma once

#include <filesystem>

namespace kerf::app {

/// What Kerf keeps between two starts that is no setting: $XDG_STATE_HOME/kerf, by default in
/// ~/.local/state; empty where there is no home.
std::filesystem::path stateFolder();

}  // namespace kerf::app

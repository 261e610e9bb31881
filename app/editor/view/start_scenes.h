#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "ui/state/start_state.h"

namespace kerf::app {

/// The scenes of the start page, in its order, with their pictures, which are read once.
std::shared_ptr<const std::vector<ui::StartCard>> startCards();
/// The session of a scene, in assets/start; its picture lies beside it.
std::filesystem::path startSession(const std::string& name);

}  // namespace kerf::app

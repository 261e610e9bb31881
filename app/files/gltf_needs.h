#pragma once

#include <filesystem>
#include <string>

namespace kerf::app {

/// An extension that a glTF or GLB file says it can't be read without, and that Kerf doesn't know;
/// empty where there is none, or no JSON.
std::string unreadableExtension(const std::filesystem::path& file);

}  // namespace kerf::app

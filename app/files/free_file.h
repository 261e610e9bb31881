#pragma once

#include <filesystem>
#include <string>

namespace kerf::app {

/// A file of that folder that does not exist yet: NAME-YYYYMMDD-HHMMSS with an ending, numbered
/// where that is taken.
std::filesystem::path freeFile(const std::filesystem::path& folder, const std::string& name,
                               const std::string& ending);

}  // namespace kerf::app

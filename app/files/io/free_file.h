#pragma once

#include <filesystem>
#include <string>

namespace kerf::app {

/// What is left of a name for a file in a folder, if it came out of a file: what stands behind the
/// last slash, at most 200 bytes, with '_' for control characters and in front of names that are
/// empty or dots.
std::string plainName(const std::string& name);

/// A file of that folder that does not exist yet: NAME-YYYYMMDD-HHMMSS with an ending, numbered
/// where that is taken. NAME is plainName(name).
std::filesystem::path freeFile(const std::filesystem::path& folder, const std::string& name,
                               const std::string& ending);

}  // namespace kerf::app

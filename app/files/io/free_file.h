#pragma once

namespace kerf::app {

/// A safe file name from a foreign one: the part after the last slash, at most 200 bytes, with '_'
/// for control characters and before names that are empty or dots.
std::string plainName(const std::string& name);

/// A new file of that folder: STEM with an ending, and with -2, -3, ... if taken.
std::filesystem::path numberedFile(const std::filesystem::path& folder, const std::string& stem,
                                   const std::string& ending);

/// A new file of that folder: NAME-YYYYMMDD-HHMMSS with an ending, numbered if taken. NAME is
/// plainName(name).
std::filesystem::path freeFile(const std::filesystem::path& folder, const std::string& name,
                               const std::string& ending);

}  // namespace kerf::app

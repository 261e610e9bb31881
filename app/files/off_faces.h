#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace kerf::app {

/// The most corners that a face of an OFF file has; 0 where none is told. assimp leaves faces of
/// more than nine corners out without a word. Reads the file line by line.
int mostCornersOfOff(const std::filesystem::path& file);

/// The text of an OFF file without comments and empty lines, which assimp counts as faces; nothing
/// where it has no comments.
std::optional<std::string> offWithoutComments(const std::filesystem::path& file);

}  // namespace kerf::app

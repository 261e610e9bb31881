#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace kerf::app {

/// The bytes of a binary PLY in a form that assimp reads right; nothing where the file has it
/// already. assimp takes a line feed at the beginning of the data for part of the header, unless
/// that ends with a carriage return and a line feed: so it does then. Reads the header alone of
/// files that are well. Throws std::runtime_error where the file can't be read.
std::optional<std::string> plyWithClearEnd(const std::filesystem::path& file);

}  // namespace kerf::app

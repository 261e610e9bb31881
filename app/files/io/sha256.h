#pragma once

#include <filesystem>
#include <string>

namespace kerf::app {

/// SHA-256 (FIPS 180-4) of a file's content as 64 lower-case hexadecimal digits. Throws InputError
/// if it can't be read.
std::string sha256OfFile(const std::filesystem::path& file);

}  // namespace kerf::app

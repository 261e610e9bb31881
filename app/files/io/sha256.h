#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace kerf::app {

/// SHA-256 (FIPS 180-4) of a file's content as 64 lower-case hexadecimal digits. Throws InputError
/// if it can't be read.
std::string sha256OfFile(const std::filesystem::path& file);
/// The same of bytes in memory.
std::string sha256Of(std::span<const std::byte> bytes);

}  // namespace kerf::app

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace kerf::app {

/// SHA-256 (FIPS 180-4) as 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);
/// The same of a file's content, read piecewise. Throws InputError where it can't be read.
std::string sha256OfFile(const std::filesystem::path& file);

}  // namespace kerf::app

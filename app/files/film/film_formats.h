#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace kerf::app {

/// Formats that a film can be written in.
enum class FilmFormat : std::uint8_t { mp4, webm, gif };

struct FilmFormatInfo {
    FilmFormat format = FilmFormat::mp4;
    std::string_view extension;  ///< ".mp4"
    std::string_view name;       ///< as people call it
    int rate = 30;               ///< pictures per second where nobody says
    bool evenSides = true;       ///< it has no pictures with an odd number of pixels in a row
};
/// All formats; the one that is offered first stands first.
std::span<const FilmFormatInfo> filmFormats();
/// The format of a file's extension; null for any other extension.
const FilmFormatInfo* filmFormatOf(const std::filesystem::path& file);
/// The extensions as a sentence lists them: ".mp4, .webm or .gif".
std::string filmEndings();

}  // namespace kerf::app

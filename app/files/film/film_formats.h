#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace kerf::app {

/// Formats of films.
enum class FilmFormat : std::uint8_t { mp4, webm, gif };

struct FilmFormatInfo {
    FilmFormat format = FilmFormat::mp4;
    std::string_view extension;  ///< ".mp4"
    std::string_view name;       ///< as people call it
    int rate = 30;               ///< default frames per second
    bool evenSides = true;       ///< it needs even numbers of pixels
};
/// All formats, in the order of the dialog.
std::span<const FilmFormatInfo> filmFormats();
/// The format of a file's extension; null for any other extension.
const FilmFormatInfo* filmFormatOf(const std::filesystem::path& file);
/// The extensions as a sentence lists them: ".mp4, .webm or .gif".
std::string filmEndings();

}  // namespace kerf::app

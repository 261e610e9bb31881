#include "app/files/film/film_formats.h"

#include <algorithm>
#include <array>

#include "sim/base/text.h"

namespace kerf::app {

std::span<const FilmFormatInfo> filmFormats() {
    // A GIF counts in hundredths of a second, of which a picture at 25 lasts four.
    static constexpr std::array kFormats{
        FilmFormatInfo{FilmFormat::mp4, ".mp4", "MP4", 30, true},
        FilmFormatInfo{FilmFormat::webm, ".webm", "WebM", 30, true},
        FilmFormatInfo{FilmFormat::gif, ".gif", "GIF", 25, false},
    };
    return kFormats;
}

const FilmFormatInfo* filmFormatOf(const std::filesystem::path& file) {
    const std::string extension = lowerCase(file.extension().string());
    const auto found = std::ranges::find(filmFormats(), extension, &FilmFormatInfo::extension);
    return found == filmFormats().end() ? nullptr : &*found;
}

std::string filmEndings() {
    const std::span<const FilmFormatInfo> all = filmFormats();
    return joined(all.first(all.size() - 1), ", ", &FilmFormatInfo::extension)
        .append(" or ")
        .append(all.back().extension);
}

}  // namespace kerf::app

#pragma once

#include "render/scene/image.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {

/// Writes a picture into a file.
inline void writePng(const render::Image& image, const std::filesystem::path& file) {
    const std::vector<std::uint8_t> bytes = render::encodePng(image);
    writeText(file, std::string(bytes.begin(), bytes.end()));
}

/// How many pixels have about this colour.
template <class Color>
int pixelsOf(const Color& color, const std::vector<std::uint8_t>& pixels) {
    int count = 0;
    for (std::size_t i = 0; i + 3 < pixels.size(); i += 4) {
        bool near = true;
        for (std::size_t k = 0; k < 3; ++k) {
            near = near && std::abs(int(pixels[i + k]) - int(color[k])) < 12;
        }
        count += near ? 1 : 0;
    }
    return count;
}

}  // namespace kerf::test

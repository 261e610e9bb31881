#pragma once

#include "render/scene/image.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {

/// Writes a picture into a file.
inline void writePng(const render::Image& image, const std::filesystem::path& file) {
    const std::vector<std::uint8_t> bytes = render::encodePng(image);
    writeText(file, std::string(bytes.begin(), bytes.end()));
}

}  // namespace kerf::test

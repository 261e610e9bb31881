#include <stb_image_write.h>

#include <stdexcept>

#include "render/scene/appearance.h"
#include "tests/support/fuzz/refusal.h"
#include "tests/support/fuzz/targets.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {

namespace {

constexpr int kSide = 9;  // [px]

render::Image colorful() {
    render::Image image{kSide, kSide, {}};
    for (int i = 0; i < kSide * kSide; ++i) {
        for (const int part : {7 * i, 255 - 3 * i, 40 + i, i % 2 == 0 ? 255 : 100}) {
            image.pixels.push_back(static_cast<std::uint8_t>(part));
        }
    }
    return image;
}

std::string text(const std::vector<std::uint8_t>& bytes) {
    return {bytes.begin(), bytes.end()};
}

std::string jpegOf(const render::Image& image, int channels, int quality) {
    std::vector<std::uint8_t> pixels;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
        pixels.insert(pixels.end(), image.pixels.begin() + static_cast<std::ptrdiff_t>(i),
                      image.pixels.begin() + static_cast<std::ptrdiff_t>(i) + channels);
    }
    std::string bytes;
    const auto append = [](void* to, void* data, int size) {
        static_cast<std::string*>(to)->append(static_cast<const char*>(data), size);
    };
    stbi_write_jpg_to_func(append, &bytes, image.width, image.height, channels, pixels.data(),
                           quality);
    return bytes;
}

/// Kerf's own pictures are PNG files, those of models are bytes.
std::string brokenFile(const std::string& bytes, const render::Image& decoded) {
    static const TemporaryFolder folder;
    writeText(folder / "a.png", bytes);
    const render::Image read = render::readPng(folder / "a.png");
    return read.pixels == decoded.pixels ? "" : "As a file it is another picture.";
}

std::string brokenByWriting(const std::string& bytes, const render::Image& image) {
    const render::Image again = render::decodeImage(text(render::encodePng(image)));
    if (again.width != image.width || again.pixels != image.pixels) {
        return "It is written otherwise.";
    }
    const bool png = render::kindOfImage(bytes) == render::ImageKind::png;
    return png ? brokenFile(bytes, image) : "";
}

}  // namespace

FuzzOutcome readImageBytes(const std::string& bytes) {
    render::Image image;
    try {
        const render::PixelRect size = render::sizeOfImage(bytes);
        image = render::decodeImage(bytes);
        if (image.width != size.width || image.height != size.height) {
            return {true, "It has another size than its head says."};
        }
    } catch (const std::runtime_error& error) {
        return refusedWithClause(error.what());
    }
    return {true, brokenByWriting(bytes, image)};
}

std::vector<std::string> imageTexts() {
    return {text(render::encodePng(colorful())), jpegOf(colorful(), 3, 90),
            jpegOf(colorful(), 1, 40)};
}

std::vector<std::string> imageWords() {
    return {std::string("\0\0\0\1", 4),
            std::string("\0\0\x40\0", 4),
            "\xff\xd8\xff",
            "\xff\xc0",
            "\xff\xc2",
            "\xff\xc4",
            "\xff\xda",
            "\xff\xdd",
            "\xff\xe0",
            "JFIF",
            "Adobe",
            "IHDR",
            "IDAT",
            "PLTE",
            "tRNS",
            "IEND",
            "CgBI",
            std::string("\0\0\0\x0d", 4)};
}

}  // namespace kerf::test

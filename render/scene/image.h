#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace kerf::render {

/// RGBA8, top row first.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels;
};

/// Divides the colours of a picture that was blended onto nothing by their alpha, as PNG wants it.
void divideByAlpha(Image& image);

/// Writes to a temporary file in the same folder, then renames. Throws std::runtime_error with one
/// sentence.
void writePng(const Image& image, const std::filesystem::path& file);
/// Throws std::runtime_error with one sentence.
Image readPng(const std::filesystem::path& file);

/// How far two images are apart.
struct ImageDifference {
    bool sameSize = false;
    double meanError = 0;      ///< mean absolute channel difference, 0 to 1
    double maxError = 0;       ///< largest channel difference, 0 to 1
    long differingPixels = 0;  ///< with a channel difference above 2/255
    Image picture;             ///< grey where equal, red where not
};
/// Pictures of different sizes are as far apart as can be, without a picture of the difference.
ImageDifference compareImages(const Image& a, const Image& b);

}  // namespace kerf::render

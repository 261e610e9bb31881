#pragma once

namespace kerf::render {

/// A rectangle of pixels, from the top left corner of the picture.
struct PixelRect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    bool operator==(const PixelRect&) const = default;
};

/// RGBA8, top row first.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels;

    template <class Io>
    void archive(Io& io) {
        io(width, height, pixels);
    }
};

/// Divides the colours of a picture on a transparent background by their alpha, as PNG needs.
void divideByAlpha(Image& image);

/// Copies a picture into `target`, with its upper left corner at a pixel, clipped.
void paste(Image& target, const Image& picture, int left, int top);

/// The bytes of a PNG file. Throws std::runtime_error with one sentence.
std::vector<std::uint8_t> encodePng(const Image& image);
/// Throws std::runtime_error with one sentence.
Image readPng(const std::filesystem::path& file);

}  // namespace kerf::render

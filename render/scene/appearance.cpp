#include "render/scene/appearance.h"

#include <stb_image.h>

#include <memory>
#include <stdexcept>

#include "render/scene/jpeg.h"

namespace kerf::render {
namespace {

// Even deflate of a picture of one colour, with a bit for a pixel, holds no more pixels in a byte.
constexpr std::size_t kMostPixelsOfByte = 8300;

const stbi_uc* data(std::string_view bytes) {
    return reinterpret_cast<const stbi_uc*>(bytes.data());
}

/// By the head, which may claim anything.
PixelRect claimedSize(std::string_view bytes) {
    if (kindOfImage(bytes) == ImageKind::jpeg) {
        return sizeOfJpeg(bytes);
    }
    PixelRect size;
    int channels = 0;
    if (stbi_info_from_memory(data(bytes), static_cast<int>(bytes.size()), &size.width,
                              &size.height, &channels) == 0 ||
        size.width < 1 || size.height < 1) {
        throw std::runtime_error("its head is damaged, or tells of more pixels than are read");
    }
    return size;
}

}  // namespace

std::string_view endingOf(ImageKind kind) {
    return kind == ImageKind::png ? ".png" : ".jpg";
}

std::string_view mediaTypeOf(ImageKind kind) {
    return kind == ImageKind::png ? "image/png" : "image/jpeg";
}

ImageKind kindOfImage(std::string_view bytes) {
    if (bytes.starts_with("\x89PNG\r\n\x1a\n")) {
        return ImageKind::png;
    }
    if (bytes.starts_with("\xFF\xD8\xFF")) {
        return ImageKind::jpeg;
    }
    throw std::runtime_error("it is neither PNG nor JPEG");
}

PixelRect sizeOfImage(std::string_view bytes) {
    const PixelRect size = claimedSize(bytes);
    const std::string sides =
        std::to_string(size.width) + " x " + std::to_string(size.height) + " pixels";
    if (size.width > kMaxTextureSide || size.height > kMaxTextureSide) {
        throw std::runtime_error("it has " + sides + ", of which at most " +
                                 std::to_string(kMaxTextureSide) + " on a side are read");
    }
    if (std::size_t(size.width) * std::size_t(size.height) / kMostPixelsOfByte > bytes.size()) {
        throw std::runtime_error("it claims " + sides + " in " + std::to_string(bytes.size()) +
                                 " bytes, so it is damaged");
    }
    return size;
}

Image decodeImage(std::string_view bytes) {
    sizeOfImage(bytes);
    if (kindOfImage(bytes) == ImageKind::jpeg) {
        return decodeJpeg(bytes);
    }
    Image image;
    int channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(data(bytes), static_cast<int>(bytes.size()), &image.width,
                              &image.height, &channels, 4),
        &stbi_image_free);
    if (!pixels) {
        throw std::runtime_error("it is damaged or cut off");
    }
    image.pixels.assign(pixels.get(), pixels.get() + std::size_t(image.width) * image.height * 4);
    return image;
}

Eigen::Vector4f shownColor(const SurfaceMaterial& material) {
    Eigen::Vector4f color = material.baseColor;
    if (material.image >= 0 && color.head<3>().isZero(0)) {
        color.head<3>().setOnes();
    }
    return color;
}

}  // namespace kerf::render

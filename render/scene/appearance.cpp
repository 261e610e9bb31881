#include "render/scene/appearance.h"

#include <stb_image.h>
#include <turbojpeg.h>

#include <stdexcept>

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

/// A JPEG file whose head was read.
class Jpeg {
  public:
    explicit Jpeg(std::string_view bytes) : bytes_(bytes) {
        int sampling = 0;
        if (tjDecompressHeader3(decoder_.get(), data(), bytes_.size(), &size_.width, &size_.height,
                                &sampling, &colors_) != 0) {
            throw std::runtime_error("its head is damaged");
        }
    }

    PixelRect size() const { return size_; }
    bool isInInks() const { return colors_ == TJCS_CMYK || colors_ == TJCS_YCCK; }

    /// Four bytes a pixel: red, green, blue and opacity, or four inks.
    Image decoded() const {
        Image image{size_.width, size_.height, {}};
        image.pixels.resize(std::size_t(4) * size_.width * size_.height);
        if (tjDecompress2(decoder_.get(), data(), bytes_.size(), image.pixels.data(), size_.width,
                          0, size_.height, isInInks() ? TJPF_CMYK : TJPF_RGBA,
                          TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS) != 0) {
            throw std::runtime_error("it is damaged or cut off");
        }
        return image;
    }

  private:
    const unsigned char* data() const {
        return reinterpret_cast<const unsigned char*>(bytes_.data());
    }

    std::string_view bytes_;
    std::unique_ptr<void, int (*)(tjhandle)> decoder_{tjInitDecompress(), &tjDestroy};
    PixelRect size_;
    int colors_ = TJCS_RGB;
};

/// Inks stand in files as what they leave of the light.
void mixInks(Image& image) {
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
        std::uint8_t* const pixel = &image.pixels[i];
        for (int part = 0; part < 3; ++part) {
            pixel[part] = static_cast<std::uint8_t>(pixel[part] * pixel[3] / 255);
        }
        pixel[3] = 255;
    }
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

PixelRect sizeOfJpeg(std::string_view bytes) {
    return Jpeg(bytes).size();
}

Image decodeJpeg(std::string_view bytes) {
    const Jpeg jpeg(bytes);
    Image image = jpeg.decoded();
    if (jpeg.isInInks()) {
        mixInks(image);
    }
    return image;
}

}  // namespace kerf::render

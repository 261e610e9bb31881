#include "render/scene/jpeg.h"

#include <turbojpeg.h>

#include <memory>
#include <stdexcept>

namespace kerf::render {
namespace {

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

#include "render/scene/image.h"

#include <stb_image.h>
#include <stb_image_write.h>

#include <cstdio>
#include <cstring>
#include <new>
#include <stdexcept>

namespace kerf::render {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxSide = 32768;
constexpr std::size_t kMaxPixels = 512u << 20;  // what stb_image reads with four channels
constexpr std::uintmax_t kMaxFileBytes = 512u << 20;

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
    throw std::runtime_error(file.string() + ": " + why + ".");
}

std::vector<std::uint8_t> readFile(const fs::path& file) {
    std::error_code error;
    if (!fs::exists(file, error)) {
        refuse(file, "there is no such file");
    }
    if (!fs::is_regular_file(file, error)) {
        refuse(file, "this is not a regular file");
    }
    const std::uintmax_t size = fs::file_size(file, error);
    if (error || size > kMaxFileBytes) {
        refuse(file, error ? error.message() : "the file is larger than 512 MB");
    }
    std::vector<std::uint8_t> bytes(size);
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(std::fopen(file.c_str(), "rb"),
                                                             &std::fclose);
    if (!in || std::fread(bytes.data(), 1, bytes.size(), in.get()) != bytes.size()) {
        refuse(file, std::string("the file could not be read: ") + std::strerror(errno));
    }
    return bytes;
}

bool isPng(const std::vector<std::uint8_t>& bytes) {
    constexpr std::array<std::uint8_t, 8> kSignature = {0x89, 'P',  'N',  'G',
                                                        '\r', '\n', 0x1a, '\n'};
    return bytes.size() >= kSignature.size() &&
           std::equal(kSignature.begin(), kSignature.end(), bytes.begin());
}

void checkSize(const std::vector<std::uint8_t>& bytes, const fs::path& file) {
    int width = 0;
    int height = 0;
    int channels = 0;
    const int size = static_cast<int>(bytes.size());
    if (stbi_info_from_memory(bytes.data(), size, &width, &height, &channels) == 0) {
        refuse(file, "the PNG header is damaged, or of a picture that is too large");
    }
    if (width > kMaxSide || height > kMaxSide) {
        refuse(file, "the picture is larger than 32768 pixels on a side");
    }
    if (std::size_t(width) * height > kMaxPixels) {
        refuse(file, "the picture has more than 512 million pixels");
    }
}

}  // namespace

void divideByAlpha(Image& image) {
    for (std::size_t i = 0; i + 3 < image.pixels.size(); i += 4) {
        const int alpha = image.pixels[i + 3];
        for (std::size_t k = i; k < i + 3 && alpha > 0; ++k) {
            const int color = (255 * image.pixels[k] + alpha / 2) / alpha;
            image.pixels[k] = static_cast<std::uint8_t>(std::min(color, 255));
        }
    }
}

void paste(Image& target, const Image& picture, int left, int top) {
    const int firstX = std::max(0, -left);
    const int firstY = std::max(0, -top);
    const int endX = std::min(picture.width, target.width - left);
    const int endY = std::min(picture.height, target.height - top);
    const auto placeOf = [](const Image& image, int x, int y) {
        return 4 * (std::ptrdiff_t{y} * image.width + x);
    };
    for (int y = firstY; y < endY && firstX < endX; ++y) {
        std::copy_n(picture.pixels.begin() + placeOf(picture, firstX, y),
                    std::ptrdiff_t{4} * (endX - firstX),
                    target.pixels.begin() + placeOf(target, left + firstX, top + y));
    }
}

std::vector<std::uint8_t> encodePng(const Image& image) {
    std::vector<std::uint8_t> bytes;
    const auto append = [](void* context, void* data, int size) {
        auto* out = static_cast<std::vector<std::uint8_t>*>(context);
        const auto* first = static_cast<const std::uint8_t*>(data);
        out->insert(out->end(), first, first + size);
    };
    if (stbi_write_png_to_func(append, &bytes, image.width, image.height, 4, image.pixels.data(),
                               image.width * 4) == 0) {
        throw std::runtime_error("The picture could not be encoded as PNG.");
    }
    return bytes;
}

Image readPng(const fs::path& file) {
    const std::vector<std::uint8_t> bytes = readFile(file);
    if (!isPng(bytes)) {
        refuse(file, "this is not a PNG picture");
    }
    checkSize(bytes, file);
    Image image;
    int channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(bytes.data(), static_cast<int>(bytes.size()), &image.width,
                              &image.height, &channels, 4),
        &stbi_image_free);
    if (!pixels && std::string_view(stbi_failure_reason()) == "outofmem") {
        throw std::bad_alloc();
    }
    if (!pixels) {
        refuse(file, "the PNG picture is damaged or cut off");
    }
    image.pixels.assign(pixels.get(), pixels.get() + std::size_t(image.width) * image.height * 4);
    return image;
}

}  // namespace kerf::render

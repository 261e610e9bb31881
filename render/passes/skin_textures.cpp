#include "render/passes/skin_textures.h"

#include <glad/gl.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

#include "gpu/context.h"

namespace kerf::render {
namespace {

// Of the extension that all desktop drivers have; glad generates the core alone.
constexpr GLenum kMaxAnisotropy = 0x84FE;
constexpr GLenum kLargestMaxAnisotropy = 0x84FF;
constexpr float kWantedAnisotropy = 8;

bool hasExtension(const char* name) {
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        const auto* extension =
            reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
        if (std::strcmp(extension, name) == 0) {
            return true;
        }
    }
    return false;
}

// Mesa's software driver (25.0) draws black at the corners of texels with it.
float anisotropy() {
    if (gpu::queryDevice().software || (!hasExtension("GL_EXT_texture_filter_anisotropic") &&
                                        !hasExtension("GL_ARB_texture_filter_anisotropic"))) {
        return 1;
    }
    float largest = 1;
    glGetFloatv(kLargestMaxAnisotropy, &largest);
    return std::min(largest, kWantedAnisotropy);
}

Image halved(const Image& image) {
    Image half{std::max(1, image.width / 2), std::max(1, image.height / 2), {}};
    for (int y = 0; y < half.height; ++y) {
        for (int x = 0; x < half.width; ++x) {
            const std::size_t from = 4 * (std::size_t(2 * y) * image.width + 2 * x);
            half.pixels.insert(half.pixels.end(), image.pixels.begin() + std::ptrdiff_t(from),
                               image.pixels.begin() + std::ptrdiff_t(from + 4));
        }
    }
    return half;
}

gpu::TextureName upload(const Image& image, float anisotropy) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (std::max(image.width, image.height) > largest) {
        return upload(halved(image), anisotropy);
    }
    const int levels = std::bit_width(unsigned(std::max(image.width, image.height)));
    gpu::TextureName texture = gpu::makeTexture(GL_TEXTURE_2D);
    const std::uint32_t id = texture.get();
    glTextureStorage2D(id, levels, GL_SRGB8_ALPHA8, image.width, image.height);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(id, 0, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE,
                        image.pixels.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glGenerateTextureMipmap(id);
    glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(id, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTextureParameteri(id, GL_TEXTURE_WRAP_T, GL_REPEAT);
    if (anisotropy > 1) {
        glTextureParameterf(id, kMaxAnisotropy, anisotropy);
    }
    return texture;
}

}  // namespace

SkinTextures::SkinTextures(std::shared_ptr<const Appearance> appearance)
    : appearance_(std::move(appearance)) {
    const float sharpness = anisotropy();
    for (std::size_t i = 0; appearance_ != nullptr && i < appearance_->images.size(); ++i) {
        const Image& image = appearance_->images[i].pixels;
        ids_.push_back(image.pixels.empty() ? gpu::TextureName() : upload(image, sharpness));
    }
}

void SkinTextures::bind(int image, std::uint32_t unit) const {
    glBindTextureUnit(unit, ids_[image].get());
}

}  // namespace kerf::render

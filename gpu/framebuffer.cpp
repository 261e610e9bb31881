#include "gpu/framebuffer.h"

#include <glad/gl.h>
#include <spdlog/fmt/fmt.h>

#include <cassert>

#include "gpu/buffer.h"
#include "gpu/context.h"

namespace kerf::gpu {
namespace {

constexpr std::size_t kBytesPerTexel = 4;

void checkSize(int width, int height) {
    assert(width > 0 && height > 0);
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    if (std::max(width, height) > limit) {
        throw OutOfMemory(
            fmt::format("A picture of {} x {} pixels is too large: this graphics driver allows {} "
                        "in each direction.",
                        width, height, limit));
    }
}

void setSampling(std::uint32_t id) {
    glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(id, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

std::vector<std::uint8_t> flippedRows(const std::vector<std::uint8_t>& pixels, int height) {
    const std::size_t stride = pixels.size() / static_cast<std::size_t>(height);
    std::vector<std::uint8_t> out;
    out.reserve(pixels.size());
    for (auto row = pixels.end(); row != pixels.begin();) {
        row -= static_cast<std::ptrdiff_t>(stride);
        out.insert(out.end(), row, row + static_cast<std::ptrdiff_t>(stride));
    }
    return out;
}

}  // namespace

Texture::Texture(std::uint32_t internalFormat, int width, int height, int samples)
    : width_(width), height_(height) {
    checkSize(width, height);
    forgetErrors();
    const bool multisampled = samples > 1;
    id_ = makeTexture(multisampled ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D);
    if (multisampled) {
        glTextureStorage2DMultisample(id(), samples, internalFormat, width, height, GL_TRUE);
    } else {
        glTextureStorage2D(id(), 1, internalFormat, width, height);
        setSampling(id());
    }
    const std::size_t texels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    throwIfOutOfMemory("a picture", texels * static_cast<std::size_t>(samples) * kBytesPerTexel);
}

void Texture::bind(std::uint32_t unit) const {
    glBindTextureUnit(unit, id());
}

Framebuffer::Framebuffer(std::uint32_t colorFormat, std::uint32_t depthFormat, int width,
                         int height, int samples)
    : width_(width), height_(height), depth_(depthFormat, width, height, samples) {
    if (colorFormat != 0) {
        color_ = Texture(colorFormat, width, height, samples);
    }
    std::uint32_t made = 0;
    glCreateFramebuffers(1, &made);
    id_ = FramebufferName(made);
    const bool stencil = depthFormat == GL_DEPTH32F_STENCIL8;
    glNamedFramebufferTexture(id(), stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
                              depth_.id(), 0);
    if (colorFormat == 0) {
        glNamedFramebufferDrawBuffer(id(), GL_NONE);
        glNamedFramebufferReadBuffer(id(), GL_NONE);
    } else {
        glNamedFramebufferTexture(id(), GL_COLOR_ATTACHMENT0, color_.id(), 0);
    }
    assert(glCheckNamedFramebufferStatus(id(), GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
}

void Framebuffer::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, id());
    glViewport(0, 0, width_, height_);
}

void Framebuffer::blitColorTo(const Framebuffer& target) const {
    assert(width_ == target.width_ && height_ == target.height_);
    glBlitNamedFramebuffer(id(), target.id(), 0, 0, width_, height_, 0, 0, width_, height_,
                           GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void Framebuffer::blitDepthTo(const Framebuffer& target) const {
    assert(width_ == target.width_ && height_ == target.height_);
    glBlitNamedFramebuffer(id(), target.id(), 0, 0, width_, height_, 0, 0, width_, height_,
                           GL_DEPTH_BUFFER_BIT, GL_NEAREST);
}

std::vector<std::uint8_t> Framebuffer::readColor() const {
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(width_) *
                                     static_cast<std::size_t>(height_) * 4);
    glGetTextureImage(color_.id(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                      static_cast<GLsizei>(pixels.size()), pixels.data());
    requireContext();
    return flippedRows(pixels, height_);
}

}  // namespace kerf::gpu

#include "gpu/framebuffer.h"

#include <glad/gl.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cassert>
#include <utility>

#include "gpu/buffer.h"
#include "gpu/context_loss.h"
#include "gpu/gl_check.h"

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
    glCreateTextures(multisampled ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D, 1, &id_);
    if (multisampled) {
        glTextureStorage2DMultisample(id_, samples, internalFormat, width, height, GL_TRUE);
    } else {
        glTextureStorage2D(id_, 1, internalFormat, width, height);
        setSampling(id_);
    }
    const std::size_t texels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    throwIfOutOfMemory("a picture", texels * static_cast<std::size_t>(samples) * kBytesPerTexel);
}

Texture::~Texture() {
    if (id_ != 0) {
        glDeleteTextures(1, &id_);
    }
}

Texture::Texture(Texture&& other) noexcept
    : id_(std::exchange(other.id_, 0)), width_(other.width_), height_(other.height_) {}

Texture& Texture::operator=(Texture&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(width_, other.width_);
    std::swap(height_, other.height_);
    return *this;
}

void Texture::bind(std::uint32_t unit) const {
    glBindTextureUnit(unit, id_);
}

Framebuffer::Framebuffer(std::uint32_t colorFormat, std::uint32_t depthFormat, int width,
                         int height, int samples)
    : width_(width), height_(height), depth_(depthFormat, width, height, samples) {
    if (colorFormat != 0) {
        color_ = Texture(colorFormat, width, height, samples);
    }
    glCreateFramebuffers(1, &id_);
    const bool stencil = depthFormat == GL_DEPTH32F_STENCIL8;
    glNamedFramebufferTexture(id_, stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
                              depth_.id(), 0);
    if (colorFormat == 0) {
        glNamedFramebufferDrawBuffer(id_, GL_NONE);
        glNamedFramebufferReadBuffer(id_, GL_NONE);
    } else {
        glNamedFramebufferTexture(id_, GL_COLOR_ATTACHMENT0, color_.id(), 0);
    }
    assert(glCheckNamedFramebufferStatus(id_, GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
}

Framebuffer::~Framebuffer() {
    if (id_ != 0) {
        glDeleteFramebuffers(1, &id_);
    }
}

Framebuffer::Framebuffer(Framebuffer&& other) noexcept
    : id_(std::exchange(other.id_, 0)),
      width_(other.width_),
      height_(other.height_),
      color_(std::move(other.color_)),
      depth_(std::move(other.depth_)) {}

Framebuffer& Framebuffer::operator=(Framebuffer&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(width_, other.width_);
    std::swap(height_, other.height_);
    std::swap(color_, other.color_);
    std::swap(depth_, other.depth_);
    return *this;
}

void Framebuffer::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, id_);
    glViewport(0, 0, width_, height_);
}

void Framebuffer::blitColorTo(const Framebuffer& target) const {
    assert(width_ == target.width_ && height_ == target.height_);
    glBlitNamedFramebuffer(id_, target.id_, 0, 0, width_, height_, 0, 0, width_, height_,
                           GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void Framebuffer::blitDepthTo(const Framebuffer& target) const {
    assert(width_ == target.width_ && height_ == target.height_);
    glBlitNamedFramebuffer(id_, target.id_, 0, 0, width_, height_, 0, 0, width_, height_,
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

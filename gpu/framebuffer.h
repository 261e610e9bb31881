#pragma once

#include "gpu/gl_name.h"

namespace kerf::gpu {

/// A 2D texture (move only).
class Texture {
  public:
    Texture() = default;
    /// `internalFormat` as GL_RGBA8, GL_DEPTH_COMPONENT32F; `samples` > 1 makes it multisampled.
    Texture(std::uint32_t internalFormat, int width, int height, int samples = 1);

    /// Binds to a texture unit, for sampler uniforms with that binding.
    void bind(std::uint32_t unit) const;
    std::uint32_t id() const { return id_.get(); }
    int width() const { return width_; }
    int height() const { return height_; }

  private:
    TextureName id_;
    int width_ = 0;
    int height_ = 0;
};

/// An off-screen target with colour (optional) and depth, with a stencil where the format of the
/// depth is GL_DEPTH32F_STENCIL8. With samples > 1 it is multisampled:
/// blit it into a plain one before reading.
class Framebuffer {
  public:
    Framebuffer() = default;
    /// `colorFormat` 0 makes a depth-only target (shadow map).
    Framebuffer(std::uint32_t colorFormat, std::uint32_t depthFormat, int width, int height,
                int samples = 1);

    /// Binds for drawing and sets the viewport to its whole size.
    void bind() const;
    /// Resolves (or copies) the colour into `target` of the same size.
    void blitColorTo(const Framebuffer& target) const;
    /// Copies the depth into `target` of the same size and depth format.
    void blitDepthTo(const Framebuffer& target) const;
    /// RGBA8, width * height * 4 bytes, top row first.
    std::vector<std::uint8_t> readColor() const;

    const Texture& color() const { return color_; }
    const Texture& depth() const { return depth_; }
    std::uint32_t id() const { return id_.get(); }
    int width() const { return width_; }
    int height() const { return height_; }

  private:
    int width_ = 0;
    int height_ = 0;
    Texture color_;
    Texture depth_;
    FramebufferName id_;  ///< deleted before what is attached to it
};

}  // namespace kerf::gpu

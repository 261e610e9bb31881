#pragma once

#include <imgui.h>

#include "gpu/framebuffer.h"
#include "render/scene/image.h"

namespace kerf::ui {

/// A picture to be drawn by Dear ImGui, and its texture. Needs a current OpenGL 4.5 context.
class Picture {
  public:
    Picture() = default;
    explicit Picture(const render::Image& image);

    /// Whether there is one.
    explicit operator bool() const { return texture_.id() != 0; }
    ImTextureID id() const;
    float width() const { return static_cast<float>(texture_.width()); }
    float height() const { return static_cast<float>(texture_.height()); }

  private:
    gpu::Texture texture_;
};

}  // namespace kerf::ui

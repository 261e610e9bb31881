#pragma once

#include <glad/gl.h>
#include <imgui.h>

#include <bit>
#include <cstdint>

#include "gpu/framebuffer.h"
#include "render/scene/image.h"

namespace kerf::ui {

/// A texture with a picture, for Dear ImGui. Needs a current OpenGL 4.5 context.
inline gpu::Texture textureOf(const render::Image& image) {
    gpu::Texture texture(GL_RGBA8, image.width, image.height);
    glTextureSubImage2D(texture.id(), 0, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE,
                        image.pixels.data());
    return texture;
}

inline ImTextureID idOf(const gpu::Texture& texture) {
    return std::bit_cast<ImTextureID>(static_cast<std::uintptr_t>(texture.id()));
}

}  // namespace kerf::ui

#include "ui/base/picture.h"

#include <glad/gl.h>

#include <bit>
#include <cstdint>

namespace kerf::ui {

Picture::Picture(const render::Image& image) : texture_(GL_RGBA8, image.width, image.height) {
    glTextureSubImage2D(texture_.id(), 0, 0, 0, image.width, image.height, GL_RGBA,
                        GL_UNSIGNED_BYTE, image.pixels.data());
}

ImTextureID Picture::id() const {
    return std::bit_cast<ImTextureID>(static_cast<std::uintptr_t>(texture_.id()));
}

}  // namespace kerf::ui

#include "gpu/gl_name.h"

#include <glad/gl.h>

namespace kerf::gpu {

void deleteTexture(std::uint32_t name) {
    glDeleteTextures(1, &name);
}

void deleteFramebuffer(std::uint32_t name) {
    glDeleteFramebuffers(1, &name);
}

TextureName makeTexture(std::uint32_t target) {
    std::uint32_t name = 0;
    glCreateTextures(target, 1, &name);
    return TextureName(name);
}

}  // namespace kerf::gpu

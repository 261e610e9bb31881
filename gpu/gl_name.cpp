#include "gpu/gl_name.h"

#include <glad/gl.h>
#include <spdlog/fmt/fmt.h>

#include "gpu/buffer.h"

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

void forgetErrors() {
    while (glGetError() != GL_NO_ERROR) {
    }
}

void throwIfOutOfMemory(std::string_view what, std::size_t bytes) {
    if (glGetError() == GL_OUT_OF_MEMORY) {
        throw OutOfMemory(fmt::format(
            "The graphics driver has no memory left for {} of {} bytes; use a smaller model or "
            "picture, or close other programs.",
            what, bytes));
    }
}

std::size_t storageLimit() {
    GLint64 most = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
    return static_cast<std::size_t>(most);
}

std::size_t texelLimit() {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    return sizeof(GLuint) * static_cast<std::size_t>(most);
}

std::size_t grownCapacity(std::size_t capacity, std::size_t bytes, std::size_t limit) {
    if (bytes > limit) {
        throw OutOfMemory(fmt::format(
            "A graphics buffer of {} bytes is needed, but this driver allows {} bytes at most; use "
            "a smaller model.",
            bytes, limit));
    }
    return std::clamp(capacity + capacity / 2, bytes, limit);
}

}  // namespace kerf::gpu

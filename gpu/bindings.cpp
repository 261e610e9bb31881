#include "gpu/bindings.h"

#include <glad/gl.h>

namespace kerf::gpu {
namespace {

GLint valueOf(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

}  // namespace

std::string clearBindings() {
    glUseProgram(0);
    glBindBuffersBase(GL_SHADER_STORAGE_BUFFER, 0, valueOf(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS),
                      nullptr);
    glBindBuffersBase(GL_UNIFORM_BUFFER, 0, valueOf(GL_MAX_UNIFORM_BUFFER_BINDINGS), nullptr);
    glBindTextures(0, valueOf(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS), nullptr);
    if (valueOf(GL_VERTEX_ARRAY_BINDING) != 0) {
        return "a vertex array";
    }
    const bool pixels =
        valueOf(GL_PIXEL_PACK_BUFFER_BINDING) != 0 || valueOf(GL_PIXEL_UNPACK_BUFFER_BINDING) != 0;
    return pixels ? "a buffer of pixels" : "";
}

}  // namespace kerf::gpu

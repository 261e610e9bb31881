#include "gpu/bindings.h"

#include <glad/gl.h>

#include <array>

namespace kerf::gpu {
namespace {

GLint valueOf(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

struct Binding {
    GLenum name;
    const char* words;
};
constexpr std::array kTakenForUnbound{
    Binding{GL_VERTEX_ARRAY_BINDING, "a vertex array"},
    Binding{GL_PIXEL_PACK_BUFFER_BINDING, "a buffer that pixels are written to"},
    Binding{GL_PIXEL_UNPACK_BUFFER_BINDING, "a buffer that pixels are read from"},
};

}  // namespace

std::string clearBindings() {
    glUseProgram(0);
    glBindBuffersBase(GL_SHADER_STORAGE_BUFFER, 0, valueOf(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS),
                      nullptr);
    glBindBuffersBase(GL_UNIFORM_BUFFER, 0, valueOf(GL_MAX_UNIFORM_BUFFER_BINDINGS), nullptr);
    glBindTextures(0, valueOf(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS), nullptr);
    for (const Binding& binding : kTakenForUnbound) {
        if (valueOf(binding.name) != 0) {
            return binding.words;
        }
    }
    return "";
}

}  // namespace kerf::gpu

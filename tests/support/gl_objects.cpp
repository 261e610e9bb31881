#include "tests/support/gl_objects.h"

#include <glad/gl.h>

namespace kerf::test {
namespace {

/// Names from 1 on, until none has been taken for long.
template <class IsTaken>
int countNames(IsTaken isTaken) {
    constexpr GLuint kLongestGap = 4096;
    int count = 0;
    for (GLuint name = 1, last = 0; name - last <= kLongestGap; ++name) {
        if (isTaken(name) == GL_TRUE) {
            ++count;
            last = name;
        }
    }
    return count;
}

}  // namespace

int GlObjects::lasting() const {
    return buffers + textures + framebuffers + vertexArrays + programs;
}

GlObjects countGlObjects() {
    return {countNames(glIsBuffer),      countNames(glIsTexture), countNames(glIsFramebuffer),
            countNames(glIsVertexArray), countNames(glIsProgram), countNames(glIsQuery)};
}

}  // namespace kerf::test

#include "tests/support/gl_objects.h"

#include <glad/gl.h>

namespace kerf::test {
namespace {

/// Names from 1 on, until none has been taken for long. Mesa gives each new object a name beyond
/// all others, so they are looked for at least up to a fresh one.
template <class IsTaken, class Generate, class Delete>
int countNames(IsTaken isTaken, Generate generate, Delete remove) {
    constexpr GLuint kLongestGap = 4096;
    GLuint fresh = 0;
    generate(1, &fresh);
    remove(1, &fresh);
    int count = 0;
    for (GLuint name = 1, last = fresh; name < last || name - last <= kLongestGap; ++name) {
        if (isTaken(name) == GL_TRUE) {
            ++count;
            last = std::max(last, name);
        }
    }
    return count;
}

}  // namespace

int GlObjects::lasting() const {
    return buffers + textures + framebuffers + vertexArrays + programs;
}

GlObjects countGlObjects() {
    const auto generateProgram = [](GLsizei, GLuint* name) { *name = glCreateProgram(); };
    const auto deleteProgram = [](GLsizei, const GLuint* name) { glDeleteProgram(*name); };
    return {countNames(glIsBuffer, glGenBuffers, glDeleteBuffers),
            countNames(glIsTexture, glGenTextures, glDeleteTextures),
            countNames(glIsFramebuffer, glGenFramebuffers, glDeleteFramebuffers),
            countNames(glIsVertexArray, glGenVertexArrays, glDeleteVertexArrays),
            countNames(glIsProgram, generateProgram, deleteProgram),
            countNames(glIsQuery, glGenQueries, glDeleteQueries)};
}

}  // namespace kerf::test

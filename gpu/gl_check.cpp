#include "gpu/gl_check.h"

#include <glad/gl.h>
#include <spdlog/fmt/fmt.h>

#include "gpu/buffer.h"

namespace kerf::gpu {

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

}  // namespace kerf::gpu

#include "gpu/context_loss.h"

#include <glad/gl.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace kerf::gpu {
namespace {

bool isPlayed() {
    static const char* const file = std::getenv("KERF_LOSE_CONTEXT");
    std::error_code error;
    return file != nullptr && std::filesystem::remove(file, error);
}

const char* causeOf(GLenum status) {
    switch (status) {
        case GL_GUILTY_CONTEXT_RESET:
            return "something that Kerf asked of it took too long or failed";
        case GL_INNOCENT_CONTEXT_RESET:
            return "another program was the cause";
        default:
            return "the driver does not say why";
    }
}

}  // namespace

void requireContext() {
    const GLenum status = isPlayed() ? GL_UNKNOWN_CONTEXT_RESET : glGetGraphicsResetStatus();
    if (status != GL_NO_ERROR) {
        throw ContextLost(std::string("The graphics driver was reset (") + causeOf(status) +
                          "), and all that was on the GPU is gone; try again, and if it comes "
                          "back, run kerf doctor.");
    }
}

}  // namespace kerf::gpu

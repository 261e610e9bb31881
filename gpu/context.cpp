#include "gpu/context.h"

#include <glad/gl.h>
#include <spdlog/spdlog.h>

#include <array>
#include <atomic>
#include <string_view>

#include "gpu/driver_threads.h"
#include "gpu/kernel_way.h"
#include "gpu/limits.h"

namespace kerf::gpu {
namespace {

std::atomic<int> debugErrors{0};

std::string text(GLenum name) {
    const GLubyte* bytes = glGetString(name);
    return bytes == nullptr ? "unknown" : reinterpret_cast<const char*>(bytes);
}

bool isSoftware(std::string_view renderer) {
    constexpr std::array<std::string_view, 3> kNames = {"llvmpipe", "softpipe", "swrast"};
    for (const std::string_view name : kNames) {
        if (renderer.find(name) != std::string_view::npos) {
            return true;
        }
    }
    return false;
}

spdlog::level::level_enum logLevel(GLenum severity) {
    switch (severity) {
        case GL_DEBUG_SEVERITY_HIGH:
            return spdlog::level::err;
        case GL_DEBUG_SEVERITY_MEDIUM:
            return spdlog::level::warn;
        default:
            return spdlog::level::debug;
    }
}

void GLAPIENTRY onDebugMessage(GLenum source, GLenum type, GLuint id, GLenum severity,
                               GLsizei length, const GLchar* message, const void* /*user*/) {
    if (source == GL_DEBUG_SOURCE_SHADER_COMPILER) {
        return;  // Program throws them, with file and line
    }
    if (type == GL_DEBUG_TYPE_ERROR) {
        ++debugErrors;
    }
    spdlog::log(logLevel(severity), "OpenGL {}: {}", id,
                std::string_view(message, static_cast<std::size_t>(length)));
}

}  // namespace

void loadFunctions(ProcLoader getProcAddress) {
    const int version = gladLoadGL(getProcAddress);
    if (version == 0) {
        throw ContextError("No OpenGL context is current, or its functions could not be found.");
    }
    if (version < GLAD_MAKE_VERSION(kNeededMajor, kNeededMinor)) {
        throw ContextError("Kerf needs OpenGL 4.5, but this driver offers " + text(GL_VERSION) +
                           " on " + text(GL_RENDERER) + ".");
    }
    if (const char* problem = problemWithKernelWay(); problem != nullptr) {
        throw ContextError(problem);
    }
    const std::string lack = sentenceOfLack(driverLimits());
    if (!lack.empty()) {
        throw ContextError(lack);
    }
    spreadDriverThreads();
}

DeviceInfo queryDevice() {
    DeviceInfo info{
        .vendor = text(GL_VENDOR), .renderer = text(GL_RENDERER), .version = text(GL_VERSION)};
    info.software = isSoftware(info.renderer);
    glGetIntegerv(GL_MAX_SAMPLES, &info.maxSamples);
    return info;
}

void enableDebugOutput() {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(onDebugMessage, nullptr);
    glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DEBUG_SEVERITY_NOTIFICATION, 0, nullptr,
                          GL_FALSE);
    // Where a driver puts its buffers, and that it compiles a shader anew: nothing to act on.
    glDebugMessageControl(GL_DONT_CARE, GL_DEBUG_TYPE_PERFORMANCE, GL_DONT_CARE, 0, nullptr,
                          GL_FALSE);
}

int takeDebugErrors() {
    return debugErrors.exchange(0);
}

}  // namespace kerf::gpu

#include "gpu/context.h"

#include <glad/gl.h>
#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <atomic>
#include <cstdlib>

#include "gpu/kernel_way.h"
#include "gpu/prompt_waits.h"

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

struct Need {
    GLenum limit;
    const char* name;
    const char* phrase;
    std::int64_t needs;
};

constexpr std::int64_t kMebi = 1 << 20;
constexpr std::int64_t kImagesOnGpus = 1;  // leaves of a search for contact

// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): the number and the name of a limit
#define KERF_LIMIT(limit) limit, #limit
// Numbers of buffers, textures, images, bytes shared and threads are what the shaders declare, as a
// test counts. The other four are sizes that OpenGL 4.5 promises anyway.
constexpr std::array kNeeds{
    Need{KERF_LIMIT(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS), "storage buffers in a compute shader",
         8},
    Need{KERF_LIMIT(GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS), "storage buffers in a vertex shader", 7},
    Need{KERF_LIMIT(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS), "bindings of storage buffers", 16},
    Need{KERF_LIMIT(GL_MAX_SHADER_STORAGE_BLOCK_SIZE), "bytes of a storage buffer", 16 * kMebi},
    Need{KERF_LIMIT(GL_MAX_TEXTURE_BUFFER_SIZE), "elements of a texture buffer", 65536},
    Need{KERF_LIMIT(GL_MAX_COMPUTE_TEXTURE_IMAGE_UNITS), "textures in a compute shader", 17},
    Need{KERF_LIMIT(GL_MAX_COMPUTE_IMAGE_UNIFORMS), "images in a compute shader", 18},
    Need{KERF_LIMIT(GL_MAX_COMPUTE_UNIFORM_BLOCKS), "uniform buffers in a compute shader", 1},
    Need{KERF_LIMIT(GL_MAX_TEXTURE_IMAGE_UNITS), "textures in a fragment shader", 3},
    Need{KERF_LIMIT(GL_MAX_COMPUTE_SHARED_MEMORY_SIZE), "bytes that a work group shares", 24576},
    Need{KERF_LIMIT(GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS), "threads of a work group", 256},
    Need{KERF_LIMIT(GL_MAX_TEXTURE_SIZE), "pixels of a texture's side", 8192},
};
#undef KERF_LIMIT

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

void requireContext() {
    const GLenum status = isPlayed() ? GL_UNKNOWN_CONTEXT_RESET : glGetGraphicsResetStatus();
    if (status != GL_NO_ERROR) {
        throw ContextLost(std::string("The graphics driver was reset (") + causeOf(status) +
                          "), and all that was on the GPU is gone; try again, and if it comes "
                          "back, run kerf doctor.");
    }
}

std::vector<DriverLimit> driverLimits() {
    std::vector<DriverLimit> limits;
    limits.reserve(kNeeds.size());
    for (const Need& need : kNeeds) {
        GLint64 has = 0;
        glGetInteger64v(need.limit, &has);
        const bool isLess =
            need.limit == GL_MAX_COMPUTE_IMAGE_UNIFORMS && kernelWay() != KernelWay::images;
        limits.push_back({need.name, need.phrase, has, isLess ? kImagesOnGpus : need.needs});
    }
    return limits;
}

std::string sentenceOfLack(std::span<const DriverLimit> limits) {
    std::string lacks;
    for (const DriverLimit& limit : limits) {
        if (limit.has < limit.needs) {
            lacks += fmt::format("{}{} {} of {}", lacks.empty() ? "" : ", ", limit.has,
                                 limit.phrase, limit.needs);
        }
    }
    return lacks.empty() ? ""
                         : "This graphics driver has too few of what Kerf needs (" + lacks +
                               "); update it, or set LIBGL_ALWAYS_SOFTWARE=1 to use the software "
                               "renderer.";
}

}  // namespace kerf::gpu

#include "gpu/limits.h"

#include <glad/gl.h>
#include <spdlog/fmt/fmt.h>

#include <array>

#include "gpu/kernel_way.h"

namespace kerf::gpu {
namespace {

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

#include "gpu/program_record.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>

namespace kerf::gpu {
namespace {

ProgramRecord*& noting() {
    static ProgramRecord* record = nullptr;
    return record;
}

/// The property that tells whether a stage refers to a resource.
GLenum referenceBy(GLenum stage) {
    return stage == GL_COMPUTE_SHADER  ? GL_REFERENCED_BY_COMPUTE_SHADER
           : stage == GL_VERTEX_SHADER ? GL_REFERENCED_BY_VERTEX_SHADER
                                       : GL_REFERENCED_BY_FRAGMENT_SHADER;
}

bool isImage(GLint type) {
    return type >= GL_IMAGE_1D && type <= GL_UNSIGNED_INT_IMAGE_2D_MULTISAMPLE_ARRAY;
}

bool isTexture(GLint type) {
    constexpr std::array kTypes{GL_SAMPLER_1D,
                                GL_SAMPLER_2D,
                                GL_SAMPLER_3D,
                                GL_SAMPLER_CUBE,
                                GL_SAMPLER_2D_SHADOW,
                                GL_SAMPLER_2D_ARRAY,
                                GL_SAMPLER_BUFFER,
                                GL_INT_SAMPLER_BUFFER,
                                GL_UNSIGNED_INT_SAMPLER_BUFFER,
                                GL_INT_SAMPLER_2D,
                                GL_UNSIGNED_INT_SAMPLER_2D,
                                GL_SAMPLER_2D_MULTISAMPLE,
                                GL_SAMPLER_CUBE_MAP_ARRAY,
                                GL_SAMPLER_2D_RECT};
    return std::ranges::find(kTypes, type) != kTypes.end();
}

int resourcesOf(GLuint program, GLenum interface) {
    GLint count = 0;
    glGetProgramInterfaceiv(program, interface, GL_ACTIVE_RESOURCES, &count);
    return count;
}

void countUniform(GLuint program, int index, GLenum stage, StageNeeds& needs) {
    const std::array<GLenum, 3> asked{referenceBy(stage), GL_TYPE, GL_ARRAY_SIZE};
    std::array<GLint, 3> told{};
    glGetProgramResourceiv(program, GL_UNIFORM, static_cast<GLuint>(index), asked.size(),
                           asked.data(), told.size(), nullptr, told.data());
    const auto [refers, type, size] = told;
    if (refers != 0) {
        needs.images += isImage(type) ? size : 0;
        needs.textures += isTexture(type) ? size : 0;
    }
}

}  // namespace

ProgramRecord::ProgramRecord() : before_(noting()) {
    noting() = this;
}

ProgramRecord::~ProgramRecord() {
    noting() = before_;
}

ProgramRecord* ProgramRecord::current() {
    return noting();
}

StageNeeds needsOf(std::uint32_t program, std::uint32_t stage) {
    StageNeeds needs;
    const GLenum reference = referenceBy(stage);
    for (int i = 0; i < resourcesOf(program, GL_SHADER_STORAGE_BLOCK); ++i) {
        GLint refers = 0;
        glGetProgramResourceiv(program, GL_SHADER_STORAGE_BLOCK, static_cast<GLuint>(i), 1,
                               &reference, 1, nullptr, &refers);
        needs.storageBuffers += refers;
    }
    for (int i = 0; i < resourcesOf(program, GL_UNIFORM); ++i) {
        countUniform(program, i, stage, needs);
    }
    if (stage == GL_COMPUTE_SHADER) {
        std::array<GLint, 3> group{};
        glGetProgramiv(program, GL_COMPUTE_WORK_GROUP_SIZE, group.data());
        needs.threads = group[0] * group[1] * group[2];
    }
    return needs;
}

}  // namespace kerf::gpu

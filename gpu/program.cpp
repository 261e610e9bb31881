#include "gpu/program.h"

#include <glad/gl.h>
#include <spdlog/spdlog.h>

#include <cassert>
#include <utility>

#include "gpu/data_path.h"
#include "gpu/shader_source.h"

namespace kerf::gpu {
namespace {

/// A shader object that is deleted at the end of its scope; the program keeps what it needs.
class Shader {
  public:
    Shader(GLenum stage, const std::string& path, const Defines& defines)
        : id_(glCreateShader(stage)) {
        try {
            compile(loadShaderSource(shaderRoot(), path, defines));
        } catch (...) {
            glDeleteShader(id_);
            throw;
        }
    }
    ~Shader() { glDeleteShader(id_); }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;
    GLuint id() const { return id_; }

  private:
    void compile(const ShaderSource& source) const {
        const char* text = source.text.c_str();
        glShaderSource(id_, 1, &text, nullptr);
        glCompileShader(id_);
        GLint compiled = 0;
        glGetShaderiv(id_, GL_COMPILE_STATUS, &compiled);
        if (compiled == 0) {
            throw ShaderError(explainLog(log(), source.files));
        }
    }

    std::string log() const {
        GLint length = 0;
        glGetShaderiv(id_, GL_INFO_LOG_LENGTH, &length);
        std::string text(static_cast<std::size_t>(length), '\0');
        glGetShaderInfoLog(id_, length, &length, text.data());
        text.resize(static_cast<std::size_t>(length));
        return text;
    }

    GLuint id_;
};

std::string linkLog(GLuint program) {
    GLint length = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string text(static_cast<std::size_t>(length), '\0');
    glGetProgramInfoLog(program, length, &length, text.data());
    text.resize(static_cast<std::size_t>(length));
    return text;
}

/// Links the shaders of `name`, which a failure is reported with.
GLuint link(const std::vector<GLuint>& shaders, const std::string& name) {
    const GLuint program = glCreateProgram();
    for (const GLuint shader : shaders) {
        glAttachShader(program, shader);
    }
    glLinkProgram(program);
    for (const GLuint shader : shaders) {
        glDetachShader(program, shader);
    }
    GLint linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked == 0) {
        const std::string log = linkLog(program);
        glDeleteProgram(program);
        throw ShaderError(name + " does not link: " + log);
    }
    return program;
}

[[maybe_unused]] GLuint maxGroups() {  // only asserted
    GLint limit = 0;
    glGetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_COUNT, 0, &limit);
    return static_cast<GLuint>(limit);
}

}  // namespace

Program Program::compute(const std::string& path, const Defines& defines) {
    const Shader shader(GL_COMPUTE_SHADER, path, defines);
    return Program(link({shader.id()}, path));
}

Program Program::graphics(const std::string& vertexPath, const std::string& fragmentPath,
                          const Defines& defines) {
    const Shader vertex(GL_VERTEX_SHADER, vertexPath, defines);
    const Shader fragment(GL_FRAGMENT_SHADER, fragmentPath, defines);
    return Program(link({vertex.id(), fragment.id()}, vertexPath + " with " + fragmentPath));
}

Program::~Program() {
    if (id_ != 0) {
        glDeleteProgram(id_);
    }
}

Program::Program(Program&& other) noexcept
    : id_(std::exchange(other.id_, 0)), locations_(std::move(other.locations_)) {}

Program& Program::operator=(Program&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(locations_, other.locations_);
    return *this;
}

void Program::use() const {
    glUseProgram(id_);
}

void Program::set(std::string_view name, int value) const {
    glProgramUniform1i(id_, location(name), value);
}

void Program::set(std::string_view name, std::uint32_t value) const {
    glProgramUniform1ui(id_, location(name), value);
}

void Program::set(std::string_view name, float value) const {
    glProgramUniform1f(id_, location(name), value);
}

void Program::set(std::string_view name, const Eigen::Vector2f& value) const {
    glProgramUniform2fv(id_, location(name), 1, value.data());
}

void Program::set(std::string_view name, const Eigen::Vector3f& value) const {
    glProgramUniform3fv(id_, location(name), 1, value.data());
}

void Program::set(std::string_view name, const Eigen::Vector4f& value) const {
    glProgramUniform4fv(id_, location(name), 1, value.data());
}

void Program::set(std::string_view name, const Eigen::Matrix4f& value) const {
    glProgramUniformMatrix4fv(id_, location(name), 1, GL_FALSE, value.data());
}

void Program::dispatch(std::uint32_t threads, std::uint32_t groupSize) const {
    if (threads == 0) {
        return;
    }
    const std::uint32_t groups = (threads - 1) / groupSize + 1;
    assert(groups <= maxGroups() && "more work groups than the driver takes in one dispatch");
    use();
    glDispatchCompute(groups, 1, 1);
}

void Program::dispatchIndirect(const Buffer& groups, std::size_t offset) const {
    assert(offset + 3 * sizeof(GLuint) <= groups.size());
    use();
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, groups.id());
    glDispatchComputeIndirect(static_cast<GLintptr>(offset));
}

int Program::location(std::string_view name) const {
    const auto found = locations_.find(name);
    if (found != locations_.end()) {
        return found->second;
    }
    const int location = glGetUniformLocation(id_, std::string(name).c_str());
    locations_.emplace(name, location);
    return location;
}

void storageBarrier() {
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                    GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

void commandBarrier() {
    glMemoryBarrier(GL_COMMAND_BARRIER_BIT);
}

void finish() {
    glFinish();
}

}  // namespace kerf::gpu

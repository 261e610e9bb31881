#include "gpu/program.h"

#include <glad/gl.h>
#include <spdlog/fmt/fmt.h>

#include <cassert>
#include <cstdlib>

#include "gpu/data_path.h"
#include "gpu/shader_source.h"
#include "gpu/traffic.h"

namespace kerf::gpu {

namespace {

/// A shader object that is deleted at the end of its scope; the program keeps what it needs.
class Shader {
  public:
    Shader(GLenum stage, const ShaderSource& source) : id_(glCreateShader(stage)) {
        try {
            compile(source);
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

using Linked = Program::Linked;

/// A file of a program, and the stage that it is for.
struct Stage {
    GLenum kind = 0;
    std::string path;
};

/// Compiles the sources of `stages` and links them into `program`; `name` is what a failure is
/// reported with.
void build(GLuint program, const std::vector<Stage>& stages,
           const std::vector<ShaderSource>& sources, const std::string& name) {
    std::vector<std::unique_ptr<Shader>> shaders;
    for (std::size_t i = 0; i < stages.size(); ++i) {
        shaders.push_back(std::make_unique<Shader>(stages[i].kind, sources[i]));
        glAttachShader(program, shaders.back()->id());
    }
    glLinkProgram(program);
    for (const auto& shader : shaders) {
        glDetachShader(program, shader->id());
    }
    GLint linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked == 0) {
        throw ShaderError(name + " does not link: " + linkLog(program));
    }
}

/// Along x; 1 for programs that draw.
GLuint groupSizeOf(GLuint program, const std::vector<Stage>& stages) {
    std::array<GLint, 3> size{1, 1, 1};
    if (stages.front().kind == GL_COMPUTE_SHADER) {
        glGetProgramiv(program, GL_COMPUTE_WORK_GROUP_SIZE, size.data());
    }
    return static_cast<GLuint>(size[0]);
}

/// For finding out whether a result hangs on a barrier that is missing.
bool wantsFullBarriers() {
    const char* barriers = std::getenv("KERF_BARRIERS");
    return barriers != nullptr && std::string_view(barriers) == "all";
}

LinkedProgram recordOf(const std::vector<Stage>& stages, const Defines& defines,
                       const std::vector<ShaderSource>& sources) {
    LinkedProgram linked{defines, {}};
    for (std::size_t i = 0; i < stages.size(); ++i) {
        linked.stages.push_back({stages[i].path, sources[i].text});
    }
    return linked;
}

std::shared_ptr<Linked> link(const std::vector<Stage>& stages, const Defines& defines,
                             const std::string& name) {
    std::vector<ShaderSource> sources;
    sources.reserve(stages.size());
    for (const Stage& stage : stages) {
        sources.push_back(loadShaderSource(shaderRoot(), stage.path, defines));
    }
    auto linked = std::make_shared<Linked>(glCreateProgram());
    build(linked->id, stages, sources, name);
    linked->groupSize = groupSizeOf(linked->id, stages);
    linked->fullBarriers = wantsFullBarriers();
    if (ProgramRecord* const record = ProgramRecord::current(); record != nullptr) {
        record->note(recordOf(stages, defines, sources));
    }
    return linked;
}

// --- Programs that are shared -------------------------------------------------------------------

/// The programs of a shelf by what they are made of; they live as long as somebody holds them.
using Shelf = std::map<std::string, std::weak_ptr<Linked>>;

struct OpenShelf {
    const ProgramShelf* owner = nullptr;
    Shelf programs;
};

/// The last one serves.
std::vector<OpenShelf>& openShelves() {
    static std::vector<OpenShelf> shelves;
    return shelves;
}

std::shared_ptr<Linked> shared(const std::vector<Stage>& stages, const Defines& defines,
                               const std::string& name) {
    if (openShelves().empty()) {
        return link(stages, defines, name);
    }
    std::string key = name;
    for (const auto& [word, value] : defines) {
        key.append("\n").append(word).append("=").append(value);
    }
    if (auto there = openShelves().back().programs[key].lock()) {
        return there;
    }
    std::shared_ptr<Linked> linked = link(stages, defines, name);
    openShelves().back().programs[key] = linked;
    return linked;
}

/// A driver leaves out a dispatch of more work groups than it takes, and says so only to those who
/// ask.
void requireGroups(GLuint groups) {
    constexpr GLuint kAlways = 65535;  // by the standard
    GLint limit = 0;
    if (groups > kAlways) {
        glGetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_COUNT, 0, &limit);
    }
    const GLuint most = std::max(kAlways, static_cast<GLuint>(limit));
    if (groups > most) {
        throw OutOfMemory(fmt::format(
            "{} work groups are needed at once, but this graphics driver starts {} at most; use a "
            "smaller model.",
            groups, most));
    }
}

ProgramRecord*& noting() {
    static ProgramRecord* record = nullptr;
    return record;
}

}  // namespace

ProgramShelf::ProgramShelf() {
    openShelves().push_back({this, {}});
}

ProgramShelf::~ProgramShelf() {
    std::erase_if(openShelves(), [this](const OpenShelf& shelf) { return shelf.owner == this; });
}

Program Program::compute(const std::string& path, const Defines& defines) {
    return Program(shared({{GL_COMPUTE_SHADER, path}}, defines, path));
}

Program Program::graphics(const std::string& vertexPath, const std::string& fragmentPath,
                          const Defines& defines) {
    return Program(shared({{GL_VERTEX_SHADER, vertexPath}, {GL_FRAGMENT_SHADER, fragmentPath}},
                          defines, vertexPath + " with " + fragmentPath));
}

Program::Linked::~Linked() {
    glDeleteProgram(id);
}

void Program::use() const {
    glUseProgram(id());
}

void Program::set(std::string_view name, int value) const {
    glProgramUniform1i(id(), location(name), value);
}

void Program::set(std::string_view name, std::uint32_t value) const {
    glProgramUniform1ui(id(), location(name), value);
}

void Program::set(std::string_view name, float value) const {
    glProgramUniform1f(id(), location(name), value);
}

void Program::set(std::string_view name, const Eigen::Vector2f& value) const {
    glProgramUniform2fv(id(), location(name), 1, value.data());
}

void Program::set(std::string_view name, const Eigen::Vector3f& value) const {
    glProgramUniform3fv(id(), location(name), 1, value.data());
}

void Program::set(std::string_view name, const Eigen::Vector4f& value) const {
    glProgramUniform4fv(id(), location(name), 1, value.data());
}

void Program::set(std::string_view name, const Eigen::Matrix4f& value) const {
    glProgramUniformMatrix4fv(id(), location(name), 1, GL_FALSE, value.data());
}

void Program::setNumbers(const DispatchNumbers& numbers) const {
    linked_->numbers.choose(numbers);
}

void Program::dispatch(std::uint32_t threads) const {
    dispatchGroups(threads / linked_->groupSize + (threads % linked_->groupSize != 0 ? 1 : 0));
}

void Program::dispatchGroups(std::uint32_t groups) const {
    requireGroups(groups);
    if (groups != 0) {
        begin();
        ++traffic().dispatches;
        glDispatchCompute(groups, 1, 1);
        end();
    }
}

void Program::dispatchIndirect(const Buffer& groups, std::size_t offset) const {
    assert(offset + 3 * sizeof(GLuint) <= groups.size());
    begin();
    ++traffic().dispatches;
    ++traffic().indirect;
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, groups.id());
    barrier(GL_COMMAND_BARRIER_BIT);
    glDispatchComputeIndirect(static_cast<GLintptr>(offset));
    end();
}

void Program::begin() const {
    use();
    linked_->numbers.bind();
    if (linked_->fullBarriers) {
        barrier(GL_ALL_BARRIER_BITS);
    }
}

// Of what a kernel leaves others read storage, texels, images and commands; copies and reads of the
// CPU have a barrier of their own (gpu/buffer.cpp).
void Program::end() const {
    constexpr GLbitfield kReadByShaders = GL_SHADER_STORAGE_BARRIER_BIT |
                                          GL_TEXTURE_FETCH_BARRIER_BIT |
                                          GL_SHADER_IMAGE_ACCESS_BARRIER_BIT;
    barrier(linked_->fullBarriers ? GL_ALL_BARRIER_BITS : kReadByShaders);
}

int Program::location(std::string_view name) const {
    const auto found = linked_->locations.find(name);
    if (found != linked_->locations.end()) {
        return found->second;
    }
    const int location = glGetUniformLocation(id(), std::string(name).c_str());
    linked_->locations.emplace(name, location);
    return location;
}

void beforeDrawingIndirect() {
    barrier(GL_COMMAND_BARRIER_BIT);
}

void finish() {
    glFinish();
}

ProgramRecord::ProgramRecord() : before_(noting()) {
    noting() = this;
}

ProgramRecord::~ProgramRecord() {
    noting() = before_;
}

ProgramRecord* ProgramRecord::current() {
    return noting();
}

}  // namespace kerf::gpu

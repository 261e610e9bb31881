#pragma once

#include <Eigen/Core>
#include <stdexcept>

#include "gpu/buffer.h"
#include "gpu/numbers_table.h"

namespace kerf::gpu {

/// A shader did not compile or link: the message has lines "file:line: error".
class ShaderError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Preprocessor definitions put behind #version: name and value.
using Defines = std::vector<std::pair<std::string, std::string>>;

/// During its lifetime programs are compiled once each: the same sources with the same definitions
/// give the same program. Of several shelves, the last one is used. It belongs to the current
/// context.
class ProgramShelf {
  public:
    ProgramShelf();
    ~ProgramShelf();
    ProgramShelf(const ProgramShelf&) = delete;
    ProgramShelf& operator=(const ProgramShelf&) = delete;
};

/// A linked OpenGL program (move only). Sources are paths below shaderRoot() (data_path.h);
/// #include "x" is resolved against the including file, then against shaderRoot() and
/// shaderRoot()/shared; "folder/*.glsl" means all such files, by name. The file need not carry
/// #version: "#version 450 core" is put in front.
class Program {
  public:
    /// Compiles and links a program. Throws ShaderError.
    static Program compute(const std::string& path, const Defines& defines = {});
    static Program graphics(const std::string& vertexPath, const std::string& fragmentPath,
                            const Defines& defines = {});
    Program() = default;
    ~Program() = default;
    Program(Program&& other) noexcept = default;
    Program& operator=(Program&& other) noexcept = default;
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void use() const;
    /// Uniforms by name (of this program, whether or not it is in use). A name that the linker
    /// removed is ignored.
    void set(std::string_view name, int value) const;
    void set(std::string_view name, std::uint32_t value) const;
    void set(std::string_view name, float value) const;
    void set(std::string_view name, const Eigen::Vector2f& value) const;
    void set(std::string_view name, const Eigen::Vector3f& value) const;
    void set(std::string_view name, const Eigen::Vector4f& value) const;
    void set(std::string_view name, const Eigen::Matrix4f& value) const;

    /// Sets the numbers of the next dispatches of the program. They are in a buffer: some drivers
    /// compile a loop over a plain uniform for its first value and keep that.
    void setNumbers(const DispatchNumbers& numbers) const;

    /// One dispatch of enough work groups along x for `threads`, none for 0. Later drawing and
    /// computing sees what it wrote. Throws OutOfMemory where the driver takes fewer groups.
    void dispatch(std::uint32_t threads) const;
    /// One dispatch of `groups` work groups along x; else like dispatch().
    void dispatchGroups(std::uint32_t groups) const;
    /// One dispatch with the number of work groups from three words (x, y, z) of a buffer, from
    /// this byte on, which kernels may have written; else like dispatch().
    void dispatchIndirect(const Buffer& groups, std::size_t offset) const;

    std::uint32_t id() const { return linked_ ? linked_->id : 0; }

    /// The OpenGL objects of a program.
    struct Linked {
        explicit Linked(std::uint32_t number) : id(number) {}
        ~Linked();
        Linked(const Linked&) = delete;
        Linked& operator=(const Linked&) = delete;

        std::uint32_t id = 0;
        std::uint32_t groupSize = 1;  ///< along x
        bool fullBarriers = false;    ///< see KERF_BARRIERS in docs/gpus.md
        NumbersTable numbers;
        std::map<std::string, int, std::less<>> locations;
    };

  private:
    explicit Program(std::shared_ptr<Linked> linked) : linked_(std::move(linked)) {}
    int location(std::string_view name) const;
    void begin() const;
    void end() const;

    std::shared_ptr<Linked> linked_;
};

/// Makes buffers written by kernels visible to indirect drawing.
void beforeDrawingIndirect();
/// Waits until the GPU has done all commands; for measurements.
void finish();

/// A compiled shader of a program.
struct LinkedStage {
    std::string file;  ///< below shaderRoot(): "sim/floor.comp"
    std::string text;  ///< with all that it includes, definitions in front
};

/// A program that was linked.
struct LinkedProgram {
    std::vector<std::pair<std::string, std::string>> defines;  ///< name and value
    std::vector<LinkedStage> stages;
};

/// During its lifetime records each linked program, but not those reused by a
/// ProgramShelf. Of several, the last one records.
class ProgramRecord {
  public:
    ProgramRecord();
    ~ProgramRecord();
    ProgramRecord(const ProgramRecord&) = delete;
    ProgramRecord& operator=(const ProgramRecord&) = delete;

    const std::vector<LinkedProgram>& programs() const { return programs_; }

    /// The active record; null for none.
    static ProgramRecord* current();
    void note(LinkedProgram program) { programs_.push_back(std::move(program)); }

  private:
    ProgramRecord* before_;
    std::vector<LinkedProgram> programs_;
};

}  // namespace kerf::gpu

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/buffer.h"

namespace kerf::gpu {

/// A shader did not compile or link: the message has lines "file:line: error".
class ShaderError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Preprocessor definitions put behind #version: name and value.
using Defines = std::vector<std::pair<std::string, std::string>>;

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
    ~Program();
    Program(Program&& other) noexcept;
    Program& operator=(Program&& other) noexcept;
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

    /// use(), then one dispatch of ceil(threads / groupSize) work groups along x; none for 0.
    void dispatch(std::uint32_t threads, std::uint32_t groupSize) const;
    /// use(), then one dispatch of as many work groups as three words (x, y, z) of a buffer say,
    /// from this byte on.
    void dispatchIndirect(const Buffer& groups, std::size_t offset) const;

    std::uint32_t id() const { return id_; }

  private:
    explicit Program(std::uint32_t id) : id_(id) {}
    int location(std::string_view name) const;

    std::uint32_t id_ = 0;
    mutable std::map<std::string, int, std::less<>> locations_;
};

/// glMemoryBarrier for what the next dispatch reads, as storage, as texels or as images.
void storageBarrier();
/// glMemoryBarrier for what dispatchIndirect() reads.
void commandBarrier();
/// Waits until the GPU has done all that it was told; for measurements.
void finish();

}  // namespace kerf::gpu

#pragma once

namespace kerf::gpu {

/// Owns an object that OpenGL knows by a number (move only). `Delete` deletes it; 0 is no object.
template <void (*Delete)(std::uint32_t)>
class GlName {
  public:
    GlName() = default;
    explicit GlName(std::uint32_t name) : name_(name) {}
    ~GlName() {
        if (name_ != 0) {
            Delete(name_);
        }
    }
    GlName(GlName&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlName& operator=(GlName&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    /// The number.
    std::uint32_t get() const { return name_; }

  private:
    std::uint32_t name_ = 0;
};

void deleteTexture(std::uint32_t name);
void deleteFramebuffer(std::uint32_t name);
using TextureName = GlName<deleteTexture>;
using FramebufferName = GlName<deleteFramebuffer>;

/// Makes a texture of this target, GL_TEXTURE_2D or another.
TextureName makeTexture(std::uint32_t target);

/// Drops pending OpenGL errors, so that the next check reports one call only.
void forgetErrors();

/// Throws OutOfMemory naming `what` and `bytes` where the driver reports GL_OUT_OF_MEMORY.
void throwIfOutOfMemory(std::string_view what, std::size_t bytes);

/// The most bytes that a shader sees of a buffer bound as storage.
std::size_t storageLimit();
/// The most bytes of a buffer that shaders read as texels of one word, the smallest.
std::size_t texelLimit();

/// The capacity of a buffer that is to grow to `bytes`: half as much again as `capacity`, at least
/// `bytes`, at most `limit`. Throws OutOfMemory if `bytes` are beyond that.
std::size_t grownCapacity(std::size_t capacity, std::size_t bytes, std::size_t limit);

}  // namespace kerf::gpu

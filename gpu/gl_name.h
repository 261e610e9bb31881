#pragma once

#include <cstdint>
#include <utility>

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

}  // namespace kerf::gpu

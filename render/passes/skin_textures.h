#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "gpu/gl_name.h"
#include "render/scene/appearance.h"

namespace kerf::render {

/// The pictures of a model as textures (move only): smaller ones for the distance, and sharp at a
/// slant where the driver can.
class SkinTextures {
  public:
    SkinTextures() = default;
    /// Uploads the pictures; of ones larger than the driver takes, every second pixel or fewer.
    explicit SkinTextures(std::shared_ptr<const Appearance> appearance);

    /// Whether these are the pictures of that appearance.
    bool areOf(const std::shared_ptr<const Appearance>& appearance) const {
        return appearance == appearance_;
    }
    /// Binds one, which must be there.
    void bind(int image, std::uint32_t unit) const;

  private:
    std::shared_ptr<const Appearance> appearance_;
    std::vector<gpu::TextureName> ids_;  // by image; none for one that can't be shown
};

}  // namespace kerf::render

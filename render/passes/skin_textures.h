#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "gpu/gl_name.h"
#include "render/scene/appearance.h"

namespace kerf::render {

/// The images of a model as textures (move only), with mipmaps and, if supported, anisotropic
/// filtering.
class SkinTextures {
  public:
    SkinTextures() = default;
    /// Uploads the images; reduces those that are larger than the driver allows.
    explicit SkinTextures(std::shared_ptr<const Appearance> appearance);

    /// Whether these are the images of that appearance.
    bool areOf(const std::shared_ptr<const Appearance>& appearance) const {
        return appearance == appearance_;
    }
    /// Binds one, which must exist.
    void bind(int image, std::uint32_t unit) const;

  private:
    std::shared_ptr<const Appearance> appearance_;
    std::vector<gpu::TextureName> ids_;  // by image; none for one that can't be shown
};

}  // namespace kerf::render

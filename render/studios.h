#pragma once

#include <array>
#include <optional>

#include "render/scene/environment.h"

namespace kerf::render {

/// The light around the scene: a studio for the dark theme and one for the bright, or for both the
/// panorama of $KERF_ENVIRONMENT. If it can't be read, the log says so, and the light is uniform.
class Studios {
  public:
    /// The one of a theme, read on first use.
    const EnvironmentTexture& of(bool bright);

  private:
    std::array<std::optional<EnvironmentTexture>, 2> textures_;
};

}  // namespace kerf::render

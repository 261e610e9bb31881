#pragma once

#include <array>
#include <optional>

#include "render/scene/environment.h"

namespace kerf::render {

/// The light around the scene: a studio for the dark theme and one for the bright, or for both the
/// panorama that $KERF_ENVIRONMENT names. One that can't be read is told in the log, and the light
/// is even.
class Studios {
  public:
    /// The one of a theme, read when it is first needed.
    const EnvironmentTexture& of(bool bright);

  private:
    std::array<std::optional<EnvironmentTexture>, 2> textures_;
};

}  // namespace kerf::render

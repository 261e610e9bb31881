#pragma once

#include "gpu/gl_name.h"
#include "sim/base/math.h"

namespace kerf::render {

/// An environment map: linear radiance, width x height, top row first; its middle column lies along
/// -z, the top is +y (an equirectangular panorama).
struct Panorama {
    int width = 0;
    int height = 0;
    std::vector<Vec3f> pixels;
};

/// Reads a panorama in Radiance's .hdr format. Throws std::runtime_error with one sentence.
Panorama readPanorama(const std::filesystem::path& file);

/// The light of a panorama, blurred by the roughness of reflecting surfaces.
struct Environment {
    /// Squares of halving sides, folded from an octahedron (environment.glsl). A byte is the square
    /// root of the radiance over kEnvironmentRange.
    static constexpr int kLevels = 5;
    static constexpr int kSide = 64;
    std::array<std::vector<std::uint8_t>, kLevels> levels;  ///< RGBA8
    /// The diffuse irradiance of a surface with normal n: matt[0] + n.x * matt[1] + n.y * matt[2] +
    /// n.z * matt[3].
    std::array<Vec3f, 4> matt{};
};
inline constexpr float kEnvironmentRange = 8;

/// Blurs a panorama for all levels, a few milliseconds.
Environment prefilter(const Panorama& panorama);
/// The level for a surface of this roughness, and the distance of the centres of its outermost
/// texels from the middle of the square, whose border is at 1.
struct MirrorLevel {
    int level = 0;
    float reach = 1;
};
MirrorLevel mirrorLevel(float roughness);

/// An environment on the GPU (move only).
class EnvironmentTexture {
  public:
    explicit EnvironmentTexture(const Environment& environment);

    void bind(std::uint32_t unit) const;
    const std::array<Vec3f, 4>& matt() const { return matt_; }

  private:
    gpu::TextureName id_;
    std::array<Vec3f, 4> matt_{};
};

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

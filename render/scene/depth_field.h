#pragma once

#include "gpu/gl_name.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::render {

/// How deep points of a closed rest shape lie below its surface, on a regular grid of samples:
/// 1 at the deepest sample, 0 on the surface, negative outside.
struct DepthField {
    std::array<int, 3> size = {0, 0, 0};  ///< samples along x, y, z
    Vec3 origin = Vec3::Zero();           ///< of sample (0, 0, 0) [m]
    double spacing = 0;                   ///< [m]
    double deepest = 0;                   ///< depth that the value 1 stands for [m]
    std::vector<float> values;            ///< x fastest

    int index(int x, int y, int z) const { return x + size[0] * (y + size[1] * z); }
};

/// Distances to the nearest living triangle in rest space: exact near the surface, further in the
/// triangle found by a neighbour is passed on by sweeping (Bridson's level-set method), inside by
/// parity along x. `resolution` samples on the longest side.
DepthField measureDepth(const SurfaceMesh& mesh, int resolution);

/// The depth below the skin, at the resolution for drawing; empty for an empty mesh. Slow for large
/// models; may run on any thread.
DepthField measureSkinDepth(const SurfaceMesh& mesh);

/// The field as a 3D texture with linear filtering (move only).
class DepthTexture {
  public:
    DepthTexture() = default;
    /// Uploads the field.
    explicit DepthTexture(const DepthField& field);

    bool empty() const { return id_.get() == 0; }
    void bind(std::uint32_t unit) const;
    /// Texture coordinate = (rest - origin()) * scale().
    const Vec3f& origin() const { return origin_; }
    const Vec3f& scale() const { return scale_; }

  private:
    gpu::TextureName id_;
    Vec3f origin_ = Vec3f::Zero();
    Vec3f scale_ = Vec3f::Ones();
};

}  // namespace kerf::render

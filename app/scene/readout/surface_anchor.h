#pragma once

#include "app/scene/readout/cut_preview.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::app {

/// A point that sticks to the material of a surface: it moves with its triangle, and after a cut
/// with the part that has its rest position.
class SurfaceAnchor {
  public:
    /// At a point that pickSurface() found.
    SurfaceAnchor(const SurfaceMesh& mesh, const SurfacePoint& point);

    /// Follows the present mesh. False, without a change, if its material was cut away. O(1), or
    /// O(triangles) if its triangle no longer exists.
    bool follow(const SurfaceMesh& mesh);
    /// Its present position [m]; reads back only its triangle if stale.
    Vec3 position(const SurfaceMesh& mesh) const;
    int triangle() const { return triangle_; }
    const Vec3& shares() const { return shares_; }  ///< of its corners
    const Vec3& rest() const { return rest_; }      ///< its position at rest [m]

  private:
    bool stands(const SurfaceMesh& mesh) const;
    std::optional<int> triangleAtRest(const SurfaceMesh& mesh) const;
    void sitOn(const SurfaceMesh& mesh, int triangle);

    int triangle_;
    Triangle corners_;  ///< of the triangle
    SurfaceKind kind_;
    Vec3 shares_;  ///< of the corners
    Vec3 rest_;    ///< at rest [m]
};

}  // namespace kerf::app

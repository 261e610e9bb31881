#pragma once

#include <optional>

#include "app/scene/readout/cut_preview.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::app {

/// A point that sticks to the material of a surface: it moves with its triangle, and goes over to
/// the one that has its place at rest where a cut divides that.
class SurfaceAnchor {
  public:
    /// At a point that pickSurface() found.
    SurfaceAnchor(const SurfaceMesh& mesh, const SurfacePoint& point);

    /// Goes on with the mesh as it is now. False where its material was cut away: nothing has
    /// changed then. O(1), or O(triangles) where its triangle is no longer there.
    bool follow(const SurfaceMesh& mesh);
    /// Where it is now [m]; reads back what is old of its triangle alone.
    Vec3 position(const SurfaceMesh& mesh) const;
    int triangle() const { return triangle_; }

  private:
    bool stands(const SurfaceMesh& mesh) const;
    std::optional<int> triangleAtRest(const SurfaceMesh& mesh) const;
    void sitOn(const SurfaceMesh& mesh, int triangle);

    int triangle_;
    Triangle corners_;  ///< of the triangle
    SurfaceKind kind_;
    Vec3 shares_;  ///< of the corners
    Vec3 rest_;    ///< where it rests [m]
};

}  // namespace kerf::app

#pragma once

#include <optional>
#include <vector>

#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// The skin as it was when a stroke began, before its triangles were divided. A vertex that the
/// stroke puts on the skin should stay on the plane of the triangle that it divides; light as it
/// is, it slips aside and folds the slivers around it over.
class FlatSkin {
  public:
    FlatSkin() = default;
    explicit FlatSkin(const SurfaceMesh& mesh);

    /// Where vertex v, made since, would be now on the undivided skin: by the barycentric
    /// coordinates of its rest position. Nothing for older vertices, and for those that rest
    /// farther than `reach` [m] from the skin.
    std::optional<Vec3> positionOf(const SurfaceMesh& mesh, int v, double reach) const;

  private:
    int vertexCount_ = 0;
    std::vector<Triangle> triangles_;
};

}  // namespace kerf::cut

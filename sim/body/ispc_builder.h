#pragma once

#include <optional>
#include <vector>

#include "shaders/shared/constraints.h"
#include "sim/body/ray_tree.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// An internal shape-preserving constraint and the mesh slot of the triangle that it ends on.
struct CastIspc {
    shared::IspcConstraint constraint{};
    int meshTriangle = -1;
};

/// Casts the ISPC of a vertex in the rest shape: from the vertex along its inward normal to the
/// first back face of the same piece.
class IspcCaster {
  public:
    /// All must outlive the caster. `tree` holds the living triangles; `edgeLength`: mean rest edge
    /// length of the uncut body [m].
    IspcCaster(const SurfaceMesh& mesh, const RayTree& tree, const std::vector<int>& pieceOfVertex,
               double edgeLength);

    /// Nothing where the vertex is unused, on a slit front (see VertexNormal::flatness), or where
    /// the ray finds no opposite side. May end on an absent triangle, which can hold no ISPC.
    /// `vertexArea`: rest area of the vertex [m^2].
    std::optional<CastIspc> cast(int vertex, double vertexArea) const;

  private:
    const SurfaceMesh& mesh_;
    const RayTree& tree_;
    const std::vector<int>& pieceOfVertex_;
    double edgeLength_;
};

/// Rest position of the far end of an ISPC [m].
Vec3 restEnd(const SurfaceMesh& mesh, const shared::IspcConstraint& constraint);

}  // namespace kerf

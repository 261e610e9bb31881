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

/// The directions of the rays of ISPCs.
enum class IspcRays {
    alongNormal,  ///< one from each vertex, against its normal, as in the paper
    /// Three from each vertex, turned from the normal in directions that vary by vertex: so they
    /// resist shear, and are equally dense everywhere and in all directions.
    turned,
};

/// How many rays leave a vertex.
constexpr int raysPerVertex(IspcRays rays) {
    return rays == IspcRays::turned ? 3 : 1;
}

/// Casts the ISPCs of a vertex in the rest shape: from the vertex inwards to the first back face of
/// the same piece.
class IspcCaster {
  public:
    /// All must outlive the caster. `tree` holds the living triangles; `edgeLength`: mean rest edge
    /// length of the uncut body [m].
    IspcCaster(const SurfaceMesh& mesh, const RayTree& tree, const std::vector<int>& pieceOfVertex,
               double edgeLength, IspcRays rays);

    /// Nothing if the vertex is unused or on a slit front (see VertexNormal::flatness), or if the
    /// ray finds no opposite side. May end on an absent triangle, which can hold no ISPC. `ray`:
    /// its number, from 0; `vertexArea`: rest area of the vertex [m^2].
    std::optional<CastIspc> cast(int vertex, int ray, double vertexArea) const;

  private:
    Vec3 direction(int vertex, int ray, const Vec3& inwards) const;
    bool pointsInside(int vertex, const Vec3& direction) const;

    const SurfaceMesh& mesh_;
    const RayTree& tree_;
    const std::vector<int>& pieceOfVertex_;
    double edgeLength_;
    IspcRays rays_;
};

/// Rest position of the far end of an ISPC [m].
Vec3 restEnd(const SurfaceMesh& mesh, const shared::IspcConstraint& constraint);

}  // namespace kerf

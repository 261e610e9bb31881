#pragma once

#include <memory>
#include <span>
#include <vector>

#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// The normals that smooth shading gives the skin at rest, carried through cuts: what is left of
/// the triangles around a vertex at the border of a wound, or flat triangles around a vertex that a
/// cut put into the middle of one, would give it another normal, and the cut would show though
/// closed.
class SkinNormals {
  public:
    SkinNormals() = default;
    /// The normals of an uncut body, weighted by the angles of the triangles around each vertex.
    explicit SkinNormals(const SurfaceMesh& uncut);

    /// Follows a step of the cutter: vertices of the skin from `firstNew` on get the normals that
    /// shading had at their places on the skin triangles `old`, which the step removed or changed.
    void follow(const SurfaceMesh& mesh, int firstNew, std::span<const Triangle> old);

    /// The unit normal of a vertex of the skin that a cut made or that lies at the border of a
    /// wound; zero for all others, whose triangles give it.
    Vec3 ofCut(const SurfaceMesh& mesh, int vertex) const;

  private:
    int uncutVertices() const { return uncut_ ? static_cast<int>(uncut_->size()) : 0; }
    const Vec3& normal(int vertex) const;

    std::shared_ptr<const std::vector<Vec3>> uncut_;  ///< shared by all copies
    std::vector<Vec3> later_;                         ///< of the vertices that cuts made
};

}  // namespace kerf

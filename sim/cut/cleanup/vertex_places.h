#pragma once

#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// The current or the rest positions of a mesh, by vertex.
class VertexPlaces {
  public:
    /// The current positions.
    static VertexPlaces current(const SurfaceMesh& mesh) { return {mesh, false}; }
    /// The rest positions.
    static VertexPlaces atRest(const SurfaceMesh& mesh) { return {mesh, true}; }
    /// The place of vertex v [m].
    const Vec3& operator[](int v) const {
        return atRest_ ? mesh_->restPosition(v) : mesh_->position(v);
    }

  private:
    VertexPlaces(const SurfaceMesh& mesh, bool atRest) : mesh_(&mesh), atRest_(atRest) {}

    const SurfaceMesh* mesh_;
    bool atRest_;
};

}  // namespace kerf::cut

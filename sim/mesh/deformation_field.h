#pragma once

#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// The current or the rest positions of a mesh, by vertex.
class VertexPositions {
  public:
    /// The current positions.
    static VertexPositions current(const SurfaceMesh& mesh) { return {mesh, false}; }
    /// The rest positions.
    static VertexPositions atRest(const SurfaceMesh& mesh) { return {mesh, true}; }
    /// The place of vertex v [m].
    const Vec3& operator[](int v) const {
        return atRest_ ? mesh_->restPosition(v) : mesh_->position(v);
    }

  private:
    VertexPositions(const SurfaceMesh& mesh, bool atRest) : mesh_(&mesh), atRest_(atRest) {}

    const SurfaceMesh* mesh_;
    bool atRest_;
};

/// The least-squares fit of a linear field to the changes of a quantity along edges. It is constant
/// along directions without edges.
class LinearField {
  public:
    /// Adds an edge along which the quantity changes by `change`.
    void add(const Vec3& edge, const Vec3& change);
    /// The change of the quantity along a vector.
    Vec3 along(const Vec3& way) const;

  private:
    Eigen::Matrix3d spread_ = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d change_ = Eigen::Matrix3d::Zero();
};

/// Maps vectors from one shape of some triangles to another: fitted to their edges and normals
/// (Sumner and Popovic, Deformation Transfer for Triangle Meshes, 2004). Where both shapes are
/// equal, so are vectors, to the last bit.
class DeformationField {
  public:
    /// Maps from the shape `from` to the shape `to`; add triangles before use.
    DeformationField(const VertexPositions& from, const VertexPositions& to)
        : from_(from), to_(to) {}

    /// Adds the edges and the normal of a triangle.
    void add(const Triangle& triangle);
    /// The vector in the shape `to` for one in the shape `from` [m].
    Vec3 along(const Vec3& way) const { return way + offset_.along(way); }

  private:
    VertexPositions from_;
    VertexPositions to_;
    LinearField offset_;  ///< change of vectors from `from` to `to`
};

}  // namespace kerf

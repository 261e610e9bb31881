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

/// The linear field that fits best, by least squares, how a quantity changes along edges. Along
/// directions that no edge takes it is constant.
class LinearField {
  public:
    /// Adds an edge along which the quantity changes by `change`.
    void add(const Vec3& edge, const Vec3& change);
    /// The change of the quantity along `way`.
    Vec3 along(const Vec3& way) const;

  private:
    Eigen::Matrix3d spread_ = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d change_ = Eigen::Matrix3d::Zero();
};

/// Maps ways in one shape of some triangles to another shape: fitted to their edges, and the normal
/// of each as one more (Sumner and Popovic, Deformation Transfer for Triangle Meshes, 2004). Where
/// both shapes are the same, ways are to the last bit.
class DeformationField {
  public:
    /// Maps from the shape `from` to the shape `to`; triangles are yet to be added.
    DeformationField(const VertexPlaces& from, const VertexPlaces& to) : from_(from), to_(to) {}

    /// Adds the edges and the normal of a triangle.
    void add(const Triangle& triangle);
    /// The way in the shape `to` that a way in the shape `from` becomes [m].
    Vec3 along(const Vec3& way) const { return way + offset_.along(way); }

  private:
    VertexPlaces from_;
    VertexPlaces to_;
    LinearField offset_;  ///< what ways gain from `from` to `to`
};

}  // namespace kerf::cut

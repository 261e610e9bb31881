#pragma once

#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// Cutting a closed mesh into two closed ones with CGAL: Polygon_mesh_processing::split by a plane,
/// then triangulate_and_refine_hole on each border at about the edge length of the mesh, with the
/// kernel of exact predicates and inexact constructions.
class CgalPlaneCut {
  public:
    /// Copies the living triangles of `mesh`.
    explicit CgalPlaneCut(const SurfaceMesh& mesh);
    ~CgalPlaneCut();
    CgalPlaneCut(const CgalPlaneCut&) = delete;
    CgalPlaneCut& operator=(const CgalPlaneCut&) = delete;

    /// Cuts the copy by the plane through `point` with `normal`. Throws std::runtime_error where a
    /// border could not be filled. To be called once.
    void run(const Vec3& point, const Vec3& normal);

    /// Volume of each connected part, ascending [m^3].
    std::vector<double> partVolumes() const;
    /// Triangles that filled the borders of both sides.
    int wallTriangles() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace kerf

#pragma once

#include <optional>
#include <vector>

#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// The surface of the body as it was when a stroke began, before its triangles were divided: the
/// skin and the walls of earlier strokes.
class StrokeSurface {
  public:
    StrokeSurface() = default;
    explicit StrokeSurface(const SurfaceMesh& mesh);

    /// Of the mesh then.
    int vertexCount() const { return vertexCount_; }
    /// Its vertices in use, ascending.
    const std::vector<int>& vertices() const { return vertices_; }

    /// Where vertex v, made since, would be now on the undivided surface: by the barycentric
    /// coordinates of its rest position. A vertex that the stroke puts on the surface is light; it
    /// slips aside and folds the slivers around it over. Nothing for older vertices, and for those
    /// that rest farther than `reach` [m] from the surface beside them.
    std::optional<Vec3> flatPosition(const SurfaceMesh& mesh, int v, double reach) const;

    /// Where vertex v, made inside the body since, would be if it had kept at least half of its
    /// depth below the undivided surface. Nothing where it has, and where it rests deeper than
    /// `reach` [m].
    std::optional<Vec3> insidePosition(const SurfaceMesh& mesh, int v, double reach) const;

  private:
    struct Part {
        Triangle corners;
        int wallLabel;
    };
    static bool isWhole(const SurfaceMesh& mesh, const Triangle& corners);
    bool isBeside(const SurfaceMesh& mesh, int v, int wallLabel) const;

    int vertexCount_ = 0;
    std::vector<int> vertices_;
    std::vector<Part> parts_;
};

}  // namespace kerf::cut

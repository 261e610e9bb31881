#pragma once

#include <functional>
#include <vector>

#include "sim/cut/blade.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/mesh/triangle_finder.h"

namespace kerf::cut {

/// Along the blade (first column), along the farthest of the `points` aside of it, and across both.
Eigen::Matrix3d sweepAxes(const Blade& blade, const std::vector<Vec3>& points);

/// Finds the triangles near parts of one sweep. Made at the start of a step from the current
/// positions: what meets the oriented box of the sweep, binned along the blade.
class BroadPhase {
  public:
    /// `points` span the sweep; triangles within `margin` [m] of their box are found, of those that
    /// `counts` lets pass.
    BroadPhase(const SurfaceMesh& mesh, TriangleFinder& finder, const Blade& blade,
               const std::vector<Vec3>& points, double margin, double binSize,
               const std::function<bool(int)>& counts);

    /// Triangles whose box meets the box of abc widened by `pad` <= margin; ascending.
    std::vector<int> query(const Vec3& a, const Vec3& b, const Vec3& c, double pad) const;

  private:
    struct Entry {
        int triangle;
        Bounds bounds;
    };
    Vec3 toFrame(const Vec3& p) const { return frame_ * p; }
    int binOf(double x) const;
    void add(const SurfaceMesh& mesh, int triangle);

    Eigen::Matrix3d frame_;  ///< rows: along the blade, along the sweep, across both
    Bounds box_;
    double binSize_ = 1;
    std::vector<Entry> entries_;
    std::vector<std::vector<int>> bins_;
};

}  // namespace kerf::cut

#pragma once

#include <functional>
#include <vector>

#include "sim/mesh/box_tree.h"
#include "sim/mesh/triangle.h"

namespace kerf {

/// The nearest of many fixed numbered triangles.
class NearestTriangle {
  public:
    /// The corners of a triangle; must be constant during its lifetime.
    using CornersOf = std::function<Corners(int id)>;

    /// A search among these triangles, of which there must be one.
    NearestTriangle(const std::vector<int>& ids, CornersOf cornersOf);

    /// The triangle nearest to p; the lowest of equally near ones.
    int find(const Vec3& p);

  private:
    Bounds boundsOf(int id) const;
    int findWithin(const Vec3& p, double reach);

    CornersOf cornersOf_;
    BoxTree tree_;
};

}  // namespace kerf

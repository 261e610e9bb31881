#pragma once

#include "sim/base/math.h"
#include "sim/mesh/box_tree.h"
#include "sim/mesh/oriented_box.h"
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
    /// The point of them nearest to p.
    Vec3 closestPoint(const Vec3& p);

  private:
    Bounds boundsOf(int id) const;
    int findWithin(const Vec3& p, double reach);

    CornersOf cornersOf_;
    BoxTree tree_;
};

/// Finds the living triangles of a mesh by their current position, while it is cut.
class TriangleFinder {
  public:
    TriangleFinder() = default;
    virtual ~TriangleFinder() = default;
    TriangleFinder(const TriangleFinder&) = default;
    TriangleFinder& operator=(const TriangleFinder&) = default;

    /// Triangles that may meet `box`; none that does is missing. Ascending.
    virtual std::vector<int> near(const OrientedBox& box) = 0;
    /// A box that holds all triangles; it may be larger than needed.
    virtual Bounds bounds() = 0;
    /// Follows a change of the mesh. `triangles`: the slots that were added or removed, or of which
    /// a corner changed; each once.
    virtual void update(std::span<const int> triangles) = 0;
};

}  // namespace kerf

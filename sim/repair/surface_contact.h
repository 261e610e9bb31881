#pragma once

#include "sim/mesh/triangle_soup.h"
#include "sim/repair/soup_editing.h"

namespace kerf::repair {

/// Whether the interiors of two triangles intersect: each has corners on both sides of the other's
/// plane, and they share more than a point. Exact.
bool passThrough(const Corners& a, const Corners& b);

/// The depth of the intersection of two triangles [m]: how far one reaches through the other within
/// its area, or their overlap along a separating axis, whichever is less. 0 if both lie in one
/// plane.
double crossingDepth(const Corners& a, const Corners& b);

/// Self-contact of the surface of a soup, with material behind each triangle: by exact signs of
/// determinants only.
class SurfaceContact {
  public:
    /// O(n log n). Keeps the soup, which must not change.
    explicit SurfaceContact(const TriangleSoup& soup);

    /// Whether the surface intersects itself at two triangles that share no edge: their interiors
    /// intersect in more than a point; or an edge of one lies in the other one or along an edge of
    /// it, and the faces beside it cross (see wedgesCross). Edges with more or fewer than two
    /// triangles don't count, since their triangles can't be paired.
    bool crosses(int a, int b) const;

  private:
    bool hasTwoFaces(int halfEdge) const;
    /// The half-edges that lie in a plane and have two faces; by the sides of it on which the
    /// triangle's corners lie.
    std::vector<int> edgesInPlane(int triangle, const std::array<int, 3>& signs) const;
    bool edgesCross(int a, const std::vector<int>& ofA, int b, const std::vector<int>& ofB) const;
    bool crossesInside(int halfEdge, int triangle) const;
    bool crossesAlong(int halfEdge, int other) const;

    const TriangleSoup& soup_;
    Partners partners_;
};

}  // namespace kerf::repair

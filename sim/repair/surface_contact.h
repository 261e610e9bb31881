#pragma once

#include <array>
#include <vector>

#include "sim/mesh/triangle_soup.h"
#include "sim/repair/soup_editing.h"

namespace kerf::repair {

/// Whether two triangles pass through each other's insides: each has corners on both sides of the
/// other one's plane, and they have more than a point in common. Exact.
bool passThrough(const Corners& a, const Corners& b);

/// How deep two triangles that pass through each other do so [m]: how far what lies over one of
/// them reaches through it, or how little of an axis along which they could be apart both cover,
/// whatever is less. 0 where both lie in one plane.
double crossingDepth(const Corners& a, const Corners& b);

/// Where the surface of a soup meets itself, with material behind each triangle: by the signs of
/// determinants alone, which are exact.
class SurfaceContact {
  public:
    /// O(n log n). Keeps the soup, which must not change.
    explicit SurfaceContact(const TriangleSoup& soup);

    /// Whether the surface passes through itself where two triangles meet that have no edge in
    /// common: their insides do, in more than a point; or an edge of one lies in the other one or
    /// along an edge of it, and the faces beside it say so (see wedgesCross). Edges that more
    /// or fewer than two triangles have don't count, since nothing tells which of these belong
    /// together.
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

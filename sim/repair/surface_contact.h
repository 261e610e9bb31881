#pragma once

#include "sim/base/math.h"
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

/// A straight line, by two different points of it.
struct Line {
    Vec3 u;
    Vec3 v;
};

/// The material between the two faces that meet in a line, each given by a point beside the line.
/// Seen with u -> v towards the eye, the material is counter-clockwise from the face at `from` to
/// the face at `to`. Of a closed surface with u -> v as an edge, `to` is the apex of the triangle
/// that runs from u to v, and `from` that of the one that runs back.
struct Wedge {
    Vec3 from;
    Vec3 to;
};

/// Whether a point lies on a line: exact.
bool isOn(const Line& line, const Vec3& p);

/// Whether two surfaces that meet along a line cross there, or share a face with their material on
/// the same side of it: exact. False if they only touch, from outside or inside, and if both faces
/// of a wedge are one.
bool wedgesCross(const Line& line, const Wedge& a, const Wedge& b);

/// An axis along which a triangle can be projected, -1 if it has no area: exact.
int axisToLeaveOut(const Vec3& a, const Vec3& b, const Vec3& c);

/// A point without one of its coordinates.
Vec2 without(int axis, const Vec3& p);

}  // namespace kerf::repair

#pragma once

#include "sim/base/math.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// Positions of the corners of a triangle [m].
using Corners = std::array<Vec3, 3>;

/// Current corners of a triangle of the mesh.
inline Corners cornersOf(const SurfaceMesh& mesh, int triangle) {
    const auto& [a, b, c] = mesh.triangle(triangle);
    return {mesh.position(a), mesh.position(b), mesh.position(c)};
}

/// Rest corners of a triangle of the mesh.
inline Corners restCornersOf(const SurfaceMesh& mesh, int triangle) {
    const auto& [a, b, c] = mesh.triangle(triangle);
    return {mesh.restPosition(a), mesh.restPosition(b), mesh.restPosition(c)};
}

/// The normal of the triangle abc, with the length of twice its area [m^2]. Seen from its tip the
/// corners run counter-clockwise.
template <class Vector>
Vector areaNormal(const Vector& a, const Vector& b, const Vector& c) {
    return (b - a).cross(c - a);
}
inline Vec3 areaNormal(const Corners& corners) {
    return areaNormal(corners[0], corners[1], corners[2]);
}

/// The normal of the triangle abc of length 1, or zero where the triangle has no area.
template <class Vector>
Vector unitNormal(const Vector& a, const Vector& b, const Vector& c) {
    return areaNormal(a, b, c).stableNormalized();
}

/// The area of the triangle abc [m^2].
inline double triangleArea(const Vec3& a, const Vec3& b, const Vec3& c) {
    return 0.5 * areaNormal(a, b, c).norm();
}
inline double triangleArea(const Corners& corners) {
    return triangleArea(corners[0], corners[1], corners[2]);
}

/// The length of the longest edge, squared [m^2].
inline double longestEdgeSquare(const Corners& corners) {
    const auto& [a, b, c] = corners;
    return std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
}

/// The length of the longest edge [m].
inline double longestEdge(const Corners& corners) {
    return std::sqrt(longestEdgeSquare(corners));
}

/// The volume of the tetrahedron over the triangle abc with its apex at the origin [m^3]: positive
/// if the apex is behind the triangle. Summed over a closed surface it is the enclosed volume.
inline double tetrahedronVolume(const Vec3& a, const Vec3& b, const Vec3& c) {
    return a.dot(b.cross(c)) / 6;
}

/// Barycentric weights of the point of the triangle abc closest to p, by the region of the plane
/// (Ericson, Real-Time Collision Detection, 5.1.5).
Vec3 closestWeights(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

/// The point of a triangle closest to p.
Vec3 closestOn(const Corners& triangle, const Vec3& p);

/// Distance of p from the segment ab.
double distanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b);

}  // namespace kerf

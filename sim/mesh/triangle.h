#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// Corners of a triangle at their places [m].
using Corners = std::array<Vec3, 3>;

/// Corners of a triangle of the mesh where they are now.
inline Corners cornersOf(const SurfaceMesh& mesh, int triangle) {
    const auto& [a, b, c] = mesh.triangle(triangle);
    return {mesh.position(a), mesh.position(b), mesh.position(c)};
}

/// Corners of a triangle of the mesh where they rest.
inline Corners restCornersOf(const SurfaceMesh& mesh, int triangle) {
    const auto& [a, b, c] = mesh.triangle(triangle);
    return {mesh.restPosition(a), mesh.restPosition(b), mesh.restPosition(c)};
}

/// The normal of the triangle abc, as long as twice its area [m^2]. It points to where the corners
/// run counter-clockwise.
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
/// where the apex lies behind the triangle. Summed over a closed surface it is the volume within.
inline double tetrahedronVolume(const Vec3& a, const Vec3& b, const Vec3& c) {
    return a.dot(b.cross(c)) / 6;
}

}  // namespace kerf

#pragma once

#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// The vertices that a fingertip at `at` touches: those of the nearest triangle, and what lies
/// within `radius` of the point along the surface [m]. The patch stops before it would hold both
/// sides of a cut, so of a slit it takes one lip. Ascending. O(triangles).
std::vector<int> surfacePatch(const SurfaceMesh& mesh, const Vec3& at, double radius);

}  // namespace kerf

#pragma once

#include "sim/mesh/surface_mesh.h"

namespace kerf::test {

/// Pairs of living triangles that pass through each other, first slot below the second, in order.
/// Signs are exact. Triangles that only touch, and neighbours folded flat onto each other, don't
/// count.
std::vector<std::pair<int, int>> selfIntersections(const SurfaceMesh& mesh);

/// The mesh with every slit opened: each copy of a vertex moves by `distance` [m] into its
/// own side, along a direction that leads behind all walls at that copy where there is one.
SurfaceMesh opened(const SurfaceMesh& mesh, double distance);

}  // namespace kerf::test

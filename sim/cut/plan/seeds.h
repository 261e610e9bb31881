#pragma once

#include <vector>

#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// Counts the groups of neighbours among `touched` triangles, ascending. The paper finds one such
/// triangle, its seed, and goes on from there over the adjacency, so it misses what hangs together
/// with no seed, such as a second arm. Here all triangles come out of the tree; this only tells how
/// many seeds that walk would need. O(k log k).
int countSeeds(const SurfaceMesh& mesh, const std::vector<int>& touched);

}  // namespace kerf::cut

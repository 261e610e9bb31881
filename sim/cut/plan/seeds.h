#pragma once

#include <vector>

#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// The paper finds one triangle that the blade meets and goes on from there over the adjacency;
/// what hangs together with no seed it misses, such as a second arm. Here all triangles come out of
/// the tree, so this only counts how many seeds that walk would need: the first triangle of each
/// group of neighbours. `touched`: ascending. O(k log k).
int countSeeds(const SurfaceMesh& mesh, const std::vector<int>& touched);

}  // namespace kerf::cut

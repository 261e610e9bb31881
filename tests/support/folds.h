#pragma once

#include <cstdint>
#include <vector>

#include "sim/mesh/surface_mesh.h"

namespace kerf::test {

/// How many edges are bent by more than 90 degrees from rest; edges of slivers don't count, nor
/// those with an end among `pinned` (ascending).
int foldedEdges(const SurfaceMesh& mesh, const std::vector<std::uint32_t>& pinned = {});

}  // namespace kerf::test

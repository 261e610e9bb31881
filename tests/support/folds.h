#pragma once

#include "sim/mesh/surface_mesh.h"

namespace kerf::test {

/// How many edges are bent by more than 90 degrees from rest; edges of slivers don't count.
int foldedEdges(const SurfaceMesh& mesh);

}  // namespace kerf::test

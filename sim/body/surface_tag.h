#pragma once

#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// The flags of a living triangle for renderer and kernels: bit 0 is its kind (1 for a wall), bit 1
/// + i says that its edge from corner i to the next one is on the rim of a cut, between skin and
/// wall, and bit 4 + i that corner i is torn.
std::uint32_t surfaceTag(const SurfaceMesh& mesh, int triangle);

}  // namespace kerf

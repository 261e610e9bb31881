#pragma once

#include <cstdint>

#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// The word that tells the renderer and the kernels of a living triangle: bit 0 is its
/// kind (1 for a wall), bit 1 + i tells that its edge from corner i to the next one lies on the rim
/// of a cut, between skin and wall.
std::uint32_t surfaceTag(const SurfaceMesh& mesh, int triangle);

}  // namespace kerf

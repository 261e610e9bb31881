#pragma once

#include <vector>

#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// Which pieces the blade sweeps as one: those that still lie against each other where a cut
/// parted them, so that a step divides the walls on both sides alike. Pieces that moved apart by
/// more than `tolerance` [m] are swept for themselves: they may overlap, and each moves the air
/// beside its rung. Returns the group of each vertex, -1 for unused ones. `before`: the groups so
/// far, which are divided but never joined; empty where there are none.
std::vector<int> groupPieces(const SurfaceMesh& mesh, const std::vector<int>& pieceOfVertex,
                             double tolerance, const std::vector<int>& before);

}  // namespace kerf::cut

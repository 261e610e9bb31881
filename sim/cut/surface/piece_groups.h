#pragma once

#include <vector>

#include "sim/mesh/piece_labels.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// Finds the groups of pieces that the blade cuts as one: pieces that still lie against each other
/// where a cut parted them, so that a step divides the walls on both sides alike. Pieces that moved
/// apart by more than `tolerance` [m] are cut for themselves: they may overlap, and each moves the
/// air beside its rung. Returns the group of each piece. `before`: the groups so far, which are
/// divided but never joined; empty where there are none. Vertices are looked at only while a group
/// has several pieces.
std::vector<int> groupPieces(const SurfaceMesh& mesh, const PieceLabels& pieces, double tolerance,
                             const std::vector<int>& before);

}  // namespace kerf::cut

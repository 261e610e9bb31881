#pragma once

#include <vector>

#include "sim/cut/cut_types.h"
#include "sim/mesh/piece_labels.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// Pieces with a wall among the triangles from `firstTriangle` on that hold less than `leastVolume`
/// [m^3] at rest; ascending. The largest piece is never among them.
std::vector<int> findDebris(const SurfaceMesh& mesh, const PieceLabels& pieces, int firstTriangle,
                            double leastVolume);

/// Takes whole pieces out of the mesh and tells `delta`, which holds what the step did so far.
/// Returns the slots that were removed, ascending. O(what is removed), and a look at all triangles
/// from `firstTriangle` on.
std::vector<int> removePieces(SurfaceMesh& mesh, const PieceLabels& pieces,
                              const std::vector<int>& which, int firstTriangle, CutDelta& delta);

}  // namespace kerf::cut

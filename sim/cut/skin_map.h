#pragma once

#include <vector>

#include "sim/cut/wall.h"

namespace kerf::cut {

/// At most about 2000 of them for each piece, thinned evenly: more cost time and change nothing
/// that can be seen. Unused vertices are left out.
std::vector<int> thinByPiece(const std::vector<int>& vertices,
                             const std::vector<int>& pieceOfVertex);

/// Gives the inner wall nodes of a step their rest positions and velocities: the affine map
/// current -> rest fitted at the node by moving least squares from the surface that the
/// same piece had before the stroke, weights 1 / (d^2 + h^2)^2, ridge 1e-3 of the trace towards the
/// identity. Samples surround the node, so nothing is extrapolated.
void mapFromSkin(const StepInput& in, const std::vector<WallSheet>& sheets, CutCurves& curves);

}  // namespace kerf::cut

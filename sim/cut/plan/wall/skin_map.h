#pragma once

#include "sim/cut/plan/wall/wall.h"

namespace kerf::cut {

/// The nodes of a step, the inner ones of walls with rest positions and velocities: the affine map
/// current -> rest fitted at the node by moving least squares from the surface that the same piece
/// had before the stroke, weights n / (d^2 + h^2)^2 for a sample that stands for n triangles, ridge
/// 1e-3 of the trace towards the identity. Samples surround the node, so it interpolates.
std::vector<CutNode> mapFromSkin(const StepInput& in, const std::vector<WallSheet>& sheets,
                                 std::vector<CutNode> nodes);

}  // namespace kerf::cut

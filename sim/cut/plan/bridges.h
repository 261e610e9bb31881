#pragma once

#include <set>
#include <vector>

#include "sim/cut/plan/step_plan.h"

namespace kerf::cut {

/// The pieces in which a rung has front edges.
std::set<int> piecesOfFront(const std::vector<RungNode>& rung,
                            const std::vector<int>& pieceOfVertex);

/// Whether a step that starts in the material of `pieces`, behind the front that it drops, may
/// leave both sides connected there. It does not if the new walls cross those of `stroke` from one
/// side to the other all along.
bool leavesBridge(const SurfaceMesh& mesh, int stroke, const std::set<int>& pieces,
                  const StepPlan& plan);

}  // namespace kerf::cut

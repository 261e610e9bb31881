#pragma once

#include <vector>

#include "sim/cut/broad_phase.h"
#include "sim/cut/cutter.h"

namespace kerf::cut {

/// Leads the rung around skin that has moved across its edges in the air: what lies behind the
/// rung is never swept, and would stay as a bridge. Between a front vertex and the air a node is
/// put a little outside the skin, its s between those of its neighbours.
/// Edges without a clear way stay as they are.
void clearAirEdges(const SurfaceMesh& mesh, const BroadPhase& broadPhase, const Blade& blade,
                   double h, std::vector<RungNode>& rung);

}  // namespace kerf::cut

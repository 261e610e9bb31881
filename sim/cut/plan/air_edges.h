#pragma once

#include "sim/cut/blade.h"
#include "sim/cut/cut_types.h"
#include "sim/cut/plan/input/slit_opening.h"
#include "sim/cut/plan/plan.h"
#include "sim/cut/surface/air_ties.h"
#include "sim/cut/surface/broad_phase.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// Routes the rung around skin that has moved across its edges in the air: material behind the rung
/// is never cut, and would stay as a bridge. Such an edge passes the points carried by the skin,
/// farther out where needed; or, beside a front vertex, a node above the skin. Edges without a free
/// path are unchanged. The mesh is seen with `opening`. `ties` are requested only if an edge is
/// obstructed. `h`: edge length about the rung [m].
void clearAirEdges(const SurfaceMesh& mesh, const BroadPhase& broadPhase,
                   const SlitOpening& opening, const Blade& blade, double h,
                   const std::function<const AirTies&()>& ties, std::vector<RungNode>& rung);

/// The pieces in which a rung has front edges.
std::set<int> piecesOfFront(const std::vector<RungNode>& rung,
                            const std::vector<int>& pieceOfVertex);

/// Whether a step that starts in the material of `pieces`, behind the front that it drops, may
/// leave both sides connected there. It does not if the new walls cross those of `stroke` from one
/// side to the other all along.
bool leavesBridge(const SurfaceMesh& mesh, int stroke, const std::set<int>& pieces,
                  const StepPlan& plan);

}  // namespace kerf::cut

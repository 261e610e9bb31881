#pragma once

#include "sim/cut/plan/wall/loops.h"

namespace kerf::cut {

/// Triangulates a sheet by cutting ears, best first; holes are bridged at the nearest pair of
/// nodes. Overlap in the layout plane is tolerated, no edge is used twice in one direction. The
/// fallback where the constrained Delaunay triangulation finds no valid polygon. Throws
/// StepFailure for a loop of two edges and where no ear is left.
std::vector<Triangle> cutEars(const Sheet2d& sheet, const std::vector<CutNode>& nodes, double h);

}  // namespace kerf::cut

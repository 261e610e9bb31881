#pragma once

#include <vector>

#include "sim/cut/plan/input/predicate_positions.h"
#include "sim/cut/plan/strip/strip.h"

namespace kerf::cut {

/// The nodes of the rung from which a step goes on, from A to B, as the predicates see them: its
/// vertices, of which those at one place share a node, and its points in the air. Pins the vertices
/// to their nodes, and what lies around the front's ends where the attempt says so.
std::vector<StripNode> oldRung(const StepInput& in, PredicatePositions& positions);

}  // namespace kerf::cut

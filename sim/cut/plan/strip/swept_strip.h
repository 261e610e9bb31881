#pragma once

#include "sim/cut/plan/input/predicate_positions.h"
#include "sim/cut/plan/strip/strip.h"

namespace kerf::cut {

/// The nodes of the old rung of a step, from A to B, as the predicates see them: its vertices,
/// where coinciding ones share a node, and its points in the air. Pins the vertices to their nodes,
/// and those around the front's ends if the attempt says so.
std::vector<StripNode> oldRung(const StepInput& in, PredicatePositions& positions);

/// Builds the strip of a step between the old rung and a new one, which has no nodes at the
/// parameters `skipped`, and pins the vertices of its nodes. Throws StepFailure.
Strip buildStrip(const StepInput& in, PredicatePositions& positions,
                 const std::vector<double>& skipped = {});

/// The triangles between two chains (node ids and their s), the first chain below. With a shared
/// end the other chain advances first, so that no triangle has three nodes on one rung.
std::vector<Triangle> stitch(const std::vector<int>& lower, const std::vector<double>& lowerS,
                             const std::vector<int>& upper, const std::vector<double>& upperS);

}  // namespace kerf::cut

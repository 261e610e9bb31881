#pragma once

#include "sim/body/constraint_lists.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::test {

/// A stretching constraint per edge of the rest shape, in the order of the edges' lower half-edges.
/// `thickness` of the shell [m].
std::vector<EdgeConstraint> buildEdges(const SurfaceMesh& mesh, double thickness);

/// A bending constraint per edge that can have one, in the order of buildEdges().
std::vector<BendConstraint> buildBends(const SurfaceMesh& mesh, double thickness);

}  // namespace kerf::test

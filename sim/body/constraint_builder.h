#pragma once

#include <vector>

#include "shaders/shared/constraints.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// A stretching constraint per edge of the rest shape, in the order of the edges' lower half-edges.
/// `thickness` of the shell [m].
std::vector<shared::EdgeConstraint> buildEdges(const SurfaceMesh& mesh, double thickness);

/// A bending constraint per edge, in the same order; none where a triangle beside the edge is a
/// sliver (height below 5 % of its longest edge): its normal is noise.
std::vector<shared::BendConstraint> buildBends(const SurfaceMesh& mesh, double thickness);

}  // namespace kerf

#pragma once

#include <optional>

#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// The dihedral angle at a half-edge [rad], flat 0, convex > 0: now and at rest. None where a
/// triangle beside it is degenerate.
std::optional<double> edgeAngle(const SurfaceMesh& mesh, int h);
std::optional<double> restEdgeAngle(const SurfaceMesh& mesh, int h);

}  // namespace kerf

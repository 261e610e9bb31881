#pragma once

#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// The position in which v and its copies meet: their mean, where none lies farther from it than
/// `distance` [m]; otherwise, and where v has no copies, v's own position. All copies that meet get
/// the same position to the last bit.
Vec3 commonPosition(const SurfaceMesh& mesh, int v, double distance);

}  // namespace kerf::cut

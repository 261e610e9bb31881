#pragma once

#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// Where all copies of the material point of v meet: their mean, where none lies farther from it
/// than `distance` [m]; otherwise, and where there are no other copies, v's own position. The same
/// to the last bit for all copies that meet.
Vec3 commonPosition(const SurfaceMesh& mesh, int v, double distance);

}  // namespace kerf::cut

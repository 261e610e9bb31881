#pragma once

#include <cstdint>
#include <vector>

#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// The running state on the CPU, shape [vertexCount].
struct BodyState {
    std::vector<Vec3f> positions;   ///< [m]
    std::vector<Vec3f> velocities;  ///< [m/s]
};

/// The state of these vertices of `mesh`, in this order, rounded to float.
BodyState stateOf(const SurfaceMesh& mesh, const std::vector<std::uint32_t>& vertices);
/// The state of all vertices of `mesh`, rounded to float.
BodyState stateOf(const SurfaceMesh& mesh);

}  // namespace kerf

#pragma once

#include "sim/base/math.h"
#include "sim/body/body_state.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// Two boxes of a metre, one above the other, that overlap a little and approach each other: a body
/// that needs the kernels of contact.
SurfaceMesh touchingBoxes();
BodyState approachingStateOf(const SurfaceMesh& touchingBoxes);
/// Around their velocities [m/s].
Bounds approachingVelocities();

}  // namespace kerf

#pragma once

#include <span>
#include <vector>

#include "sim/base/math.h"

namespace kerf::app {

/// The triangles of a face, as numbers of its corners, which are indices into `positions`. One that
/// crosses itself, encloses no area, or has a corner that is not there becomes a fan.
std::vector<Triangle> trianglesOfFace(std::span<const Vec3> positions, std::span<const int> face);

}  // namespace kerf::app

#pragma once

#include <Eigen/Core>

#include "sim/base/math.h"

namespace kerf {

/// Turns about the world's x, then y, then z axis [degrees].
Eigen::Matrix3d turnOf(const Vec3& degrees);

}  // namespace kerf

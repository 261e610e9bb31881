#pragma once

#include <Eigen/Core>

#include "sim/base/math.h"

namespace kerf {

/// Turns about the world's x, then y, then z axis [degrees].
Eigen::Matrix3d turnOf(const Vec3& degrees);
/// The angles of such turns that a rotation is made of, each from -180 to 180 [degrees].
Vec3 turnsOf(const Eigen::Matrix3d& rotation);

}  // namespace kerf

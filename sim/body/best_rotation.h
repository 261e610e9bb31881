#pragma once

#include "sim/base/math.h"

namespace kerf {

/// The rotation that brings points with this covariance (sum of current rest^T) closest together
/// (Kabsch 1976).
Eigen::Matrix3d bestRotation(const Eigen::Matrix3d& covariance);

}  // namespace kerf

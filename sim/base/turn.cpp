#include "sim/base/turn.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace kerf {

Eigen::Matrix3d turnOf(const Vec3& degrees) {
    const Vec3 radians = degrees * (EIGEN_PI / 180);
    return (Eigen::AngleAxisd(radians.z(), Vec3::UnitZ()) *
            Eigen::AngleAxisd(radians.y(), Vec3::UnitY()) *
            Eigen::AngleAxisd(radians.x(), Vec3::UnitX()))
        .toRotationMatrix();
}

Vec3 turnsOf(const Eigen::Matrix3d& r) {
    constexpr double kUpright = 1 - 1e-12;  // x and z turn about the same axis then
    const double y = std::asin(std::clamp(-r(2, 0), -1.0, 1.0));
    const bool upright = std::abs(r(2, 0)) > kUpright;
    const double x = upright ? std::atan2(-r(1, 2), r(1, 1)) : std::atan2(r(2, 1), r(2, 2));
    const double z = upright ? 0 : std::atan2(r(1, 0), r(0, 0));
    return Vec3(x, y, z) * (180 / EIGEN_PI);
}

}  // namespace kerf

#include "sim/base/turn.h"

#include <Eigen/Geometry>

namespace kerf {

Eigen::Matrix3d turnOf(const Vec3& degrees) {
    const Vec3 radians = degrees * (EIGEN_PI / 180);
    return (Eigen::AngleAxisd(radians.z(), Vec3::UnitZ()) *
            Eigen::AngleAxisd(radians.y(), Vec3::UnitY()) *
            Eigen::AngleAxisd(radians.x(), Vec3::UnitX()))
        .toRotationMatrix();
}

}  // namespace kerf

#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>

namespace kerf {

/// Positions in metres, right-handed, +y up. Doubles on the CPU, floats on the GPU.
using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Vec3f = Eigen::Vector3f;

/// Corners of a triangle, counter-clockwise seen from outside.
using Triangle = std::array<int, 3>;

struct Bounds {
    Vec3 low = Vec3::Constant(1e300);
    Vec3 high = Vec3::Constant(-1e300);
    void add(const Vec3& p) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    bool empty() const { return low.x() > high.x(); }
    Vec3 center() const { return 0.5 * (low + high); }
    double diagonal() const { return empty() ? 0.0 : (high - low).norm(); }
};

}  // namespace kerf

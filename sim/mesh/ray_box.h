#pragma once

#include <algorithm>

#include "sim/base/math.h"

namespace kerf {

/// A ray as boxes are asked for it. `direction` need not have length 1; along an axis in which it
/// does not move it is taken to come through where it starts between the box's sides.
struct BoxRay {
    BoxRay(const Vec3& from, const Vec3& along) : origin(from), direction(along) {
        for (int axis = 0; axis < 3; ++axis) {
            inverse[axis] = along[axis] != 0 ? 1 / along[axis] : 1e200;
        }
    }
    Vec3 origin, direction, inverse;
};

inline constexpr double kMissesBox = 1e301;

/// The place where the ray enters the box, in lengths of its direction, at least 0; kMissesBox if
/// it does not before `farthest`. Shares of the ray between the planes of each axis (Kay and Kajiya
/// 1986).
inline double entryInto(const Bounds& box, const BoxRay& ray, double farthest) {
    const Vec3 toLow = (box.low - ray.origin).cwiseProduct(ray.inverse);
    const Vec3 toHigh = (box.high - ray.origin).cwiseProduct(ray.inverse);
    const double enter = std::max(0.0, toLow.cwiseMin(toHigh).maxCoeff());
    const double leave = std::min(farthest, toLow.cwiseMax(toHigh).minCoeff());
    return enter <= leave ? enter : kMissesBox;
}

}  // namespace kerf

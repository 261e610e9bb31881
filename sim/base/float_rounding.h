#pragma once

#include "sim/base/math.h"

namespace kerf {

/// The float nearest to `x`, as the GPU will hold it. Through a volatile: with optimisation GCC 12
/// (12.2, its vectoriser of straight-line code) leaves (double)(float)x as x where two of them
/// stand side by side.
inline double nearestFloat(double x) {
    const volatile float rounded = static_cast<float>(x);
    return rounded;
}

/// The vector of floats nearest to `a`, component by component.
inline Vec3 nearestFloats(const Vec3& a) {
    return {nearestFloat(a.x()), nearestFloat(a.y()), nearestFloat(a.z())};
}

}  // namespace kerf

#pragma once

#include "sim/base/math.h"

namespace kerf {

/// The blade is the segment AB [m].
struct Blade {
    Vec3 a = Vec3::Zero();  ///< its end A [m]
    Vec3 b = Vec3::Zero();  ///< its end B [m]
};

/// Linear interpolation of both ends: `from` at t = 0, `to` at t = 1.
inline Blade interpolate(const Blade& from, const Blade& to, double t) {
    return {from.a + (to.a - from.a) * t, from.b + (to.b - from.b) * t};
}

}  // namespace kerf

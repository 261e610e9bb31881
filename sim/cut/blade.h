#pragma once

#include "sim/base/math.h"

namespace kerf {

/// The blade is the segment AB [m].
struct Blade {
    Vec3 a = Vec3::Zero();  ///< its end A [m]
    Vec3 b = Vec3::Zero();  ///< its end B [m]
};

/// The blade on the straight way of both its ends: at `from` for t = 0, at `to` for t = 1.
inline Blade interpolate(const Blade& from, const Blade& to, double t) {
    return {from.a + (to.a - from.a) * t, from.b + (to.b - from.b) * t};
}

}  // namespace kerf

#pragma once

#include "sim/base/math.h"

namespace kerf {

/// The blade is the segment AB [m].
struct Blade {
    Vec3 a = Vec3::Zero();
    Vec3 b = Vec3::Zero();
};

/// The blade on the straight way of both ends, at `from` for t = 0 and at `to` for 1.
inline Blade interpolate(const Blade& from, const Blade& to, double t) {
    return {from.a + (to.a - from.a) * t, from.b + (to.b - from.b) * t};
}

}  // namespace kerf

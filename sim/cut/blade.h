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

namespace kerf::cut {

/// The point of the blade's line at parameter s: A at 0, B at 1 [m].
inline Vec3 pointOn(const Blade& blade, double s) {
    return blade.a + (blade.b - blade.a) * s;
}

/// The length of the blade [m].
inline double lengthOf(const Blade& blade) {
    return (blade.b - blade.a).norm();
}

/// The component of a vector across the blade.
inline Vec3 across(const Blade& blade, const Vec3& way) {
    const Vec3 along = (blade.b - blade.a).normalized();
    return way - along * along.dot(way);
}

}  // namespace kerf::cut

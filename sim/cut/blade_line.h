#pragma once

#include "sim/cut/blade.h"

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

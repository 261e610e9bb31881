#pragma once

#include <span>

#include "sim/base/math.h"

namespace kerf {

/// The axis-parallel box of these points [m].
inline Bounds boxOf(std::span<const Vec3> points) {
    Bounds box;
    for (const Vec3& p : points) {
        box.add(p);
    }
    return box;
}

}  // namespace kerf

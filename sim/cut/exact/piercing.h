#pragma once

#include "sim/base/math.h"

namespace kerf::cut {

/// Whether the inside of segment pq passes through the inside of the triangle: exact, false if they
/// only touch.
bool pierces(const Vec3& p, const Vec3& q, const std::array<Vec3, 3>& triangle);

}  // namespace kerf::cut

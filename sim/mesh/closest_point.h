#pragma once

#include "sim/base/math.h"

namespace kerf {

/// Barycentric weights of the point of the triangle abc closest to p, by the region of the plane
/// (Ericson, Real-Time Collision Detection, 5.1.5).
Vec3 closestWeights(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

/// Distance of p from the segment ab.
double distanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b);

}  // namespace kerf

#pragma once

#include <vector>

#include "sim/base/math.h"

namespace kerf::repair {

/// Divides a polygon with corners in turn into triangles of its corners' numbers that face as it
/// does: a constrained Delaunay triangulation, seen along the axis that its normal is closest to,
/// or along that. Corners may repeat, and an edge may lead to a hole and back. Empty where the
/// polygon crosses or touches itself otherwise, or encloses no area. O(n log n) as a rule.
std::vector<Triangle> triangulatePolygon(const std::vector<Vec3>& corners);

}  // namespace kerf::repair

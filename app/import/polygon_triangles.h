#pragma once

#include "sim/base/math.h"

namespace kerf::app {

/// Divides a polygon, given by its corners in order, into triangles of corner numbers with its
/// orientation: a constrained Delaunay triangulation, projected along the axis closest to its
/// normal, or along that. Corners may repeat, and an edge may lead to a hole and back. Empty if the
/// polygon crosses or touches itself otherwise, or encloses no area. Usually O(n log n).
std::vector<Triangle> triangulatePolygon(const std::vector<Vec3>& corners);

}  // namespace kerf::app

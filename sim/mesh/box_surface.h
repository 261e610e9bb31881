#pragma once

#include <array>

#include "sim/mesh/triangle_soup.h"

namespace kerf {

/// The surface of an axis-parallel box around the origin, two triangles for each square of a grid
/// of `cells` (at least 1 along each axis). Diagonals alternate (Union Jack pattern), so that faces
/// resist shear equally in both directions. Closed, outward-oriented.
TriangleSoup boxSurface(const Vec3& size, const std::array<int, 3>& cells);

}  // namespace kerf

#pragma once

#include "sim/mesh/triangle_soup.h"

namespace kerf::app {

/// Moves vertices apart that coincide as floats, except those of touching solids, which are pieces:
/// solids and cavities shrink, and what surrounds another one grows, by a thousandth of an edge, or
/// more if needed. Otherwise readers of the file would join them again. Returns the number of
/// moves, 0 if all were apart. O(n log n).
int moveApart(TriangleSoup& soup);

}  // namespace kerf::app

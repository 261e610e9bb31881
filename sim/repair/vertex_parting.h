#pragma once

#include "sim/mesh/triangle_soup.h"

namespace kerf::repair {

/// Moves vertices apart that lie at one place, as a file of floats holds it, but those of solids
/// that touch, which are pieces there: solids and hollows shrink, and what lies around another one
/// grows, by a thousandth of an edge, or more where that is not enough. Else who reads the file
/// would join them again. Returns how many moves that took, 0 where all were apart. O(n log n).
int moveApart(TriangleSoup& soup);

}  // namespace kerf::repair

#pragma once

#include "sim/mesh/triangle_soup.h"

namespace kerf::app {

/// Drops duplicate triangles. Around a sheet of them the single triangles decide how many copies
/// close the surface. One copy stays where an odd number of others meets it: it was duplicated, on
/// one side or both. Elsewhere an even number stays: two of the same orientation, as on a face that
/// two solids share, and none of a flap or of the wall between two solids. The result for a sheet
/// decides about those beside it; otherwise the largest one stays. Of a closed sheet one copy
/// stays, and of an isolated open one, but of a flap none. Returns how many were dropped. O(n log
/// n), times the number of adjacent sheets.
int dropDoubles(TriangleSoup& soup);

}  // namespace kerf::app

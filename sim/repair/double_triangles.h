#pragma once

#include "sim/mesh/triangle_soup.h"

namespace kerf::repair {

/// Drops triangles that are there more than once. Around a sheet of them the single triangles tell
/// how many copies close the surface. One copy stays where an odd number of others meets it: it was
/// doubled, on one side or both. Elsewhere an even number stays: two where they face alike, as
/// where two solids have that face in common, and none of a flap or of the wall between two solids.
/// What is decided of a sheet tells about those beside it; where nothing does, the largest one
/// stays. Of a closed sheet one copy stays, and of an open one that nothing else meets, but of a
/// flap none. Returns how many were dropped. O(n log n), times the sheets that lie in a row.
int dropDoubles(TriangleSoup& soup);

}  // namespace kerf::repair

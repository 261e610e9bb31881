#pragma once

#include "sim/mesh/triangle_soup.h"

namespace kerf::repair {

/// What fillHolesEvenly() did.
struct FilledHoles {
    int holes = 0;
    int triangles = 0;  ///< that were added
};

/// fillHoles(), then divides the new triangles to the size of those around the hole, and evens out
/// where they lie.
FilledHoles fillHolesEvenly(TriangleSoup& soup);

}  // namespace kerf::repair

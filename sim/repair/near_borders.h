#pragma once

#include "sim/mesh/triangle_soup.h"

namespace kerf::repair {

/// What joinNearBorders() did.
struct JoinedBorders {
    int vertices = 0;  ///< that became others
    int edges = 0;     ///< that were divided
};

/// Joins vertices of open edges with others within a hundred-thousandth of the model's diagonal,
/// and divides open edges on which vertices of others lie. Where a file was written with few
/// digits, or triangles meet in a T, that closes the surface. Nothing else moves.
JoinedBorders joinNearBorders(TriangleSoup& soup);

}  // namespace kerf::repair

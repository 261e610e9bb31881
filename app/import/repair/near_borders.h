#pragma once

#include "sim/mesh/triangle_soup.h"

namespace kerf::app {

/// The result of joinNearBorders().
struct JoinedBorders {
    int vertices = 0;  ///< that were merged
    int edges = 0;     ///< that were divided
};

/// Joins vertices of open edges with others within a hundred-thousandth of the model's diagonal,
/// and divides open edges on which vertices of others lie. This closes surfaces of files with few
/// digits, or with T-junctions. Nothing else moves.
JoinedBorders joinNearBorders(TriangleSoup& soup);

}  // namespace kerf::app

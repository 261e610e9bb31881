#pragma once

#include "sim/mesh/triangle_soup.h"

namespace kerf::app {

/// The result of uniting intersecting pieces.
struct PieceUnion {
    std::vector<std::string> done;  ///< "united 2 pieces that crossed", a phrase for each group
    std::vector<std::string> left;  ///< what is unchanged and why, a sentence each
};

/// Makes one surface of each group of intersecting pieces: the boundary of their union.
/// Intersections are computed exactly and then rounded. Pieces without intersections, and those
/// that can't be united, stay bit for bit. Colours, texture coordinates and materials stay in
/// place. The soup must be one that can be cut. A group may take two minutes of processor time,
/// in a process of its own. O(n log n).
PieceUnion uniteCrossingPieces(TriangleSoup& welded);

}  // namespace kerf::app

#pragma once

#include "app/files/jobs/background_job.h"
#include "sim/mesh/triangle_soup.h"

namespace kerf::app {

/// The result of uniting intersecting pieces.
struct ShellUnion {
    std::vector<std::string> done;  ///< "united 2 pieces that crossed", a phrase for each group
    std::vector<std::string> left;  ///< what is unchanged and why, a sentence each
};

/// Makes one surface of each group of intersecting pieces: the boundary of their union.
/// Intersections are computed exactly and then rounded. Pieces without intersections, and those
/// that can't be united, stay bit for bit. Colours, texture coordinates and materials stay in
/// place. The soup must be one that can be cut. Runs the program `kerf-unite`, within limits of
/// time and memory; without it nothing changes. O(n log n). Throws WorkCancelled.
ShellUnion uniteCrossingPieces(TriangleSoup& welded, WorkProgress* progress = nullptr);

/// What uniteCrossingPieces() would do: a clause for each group of intersecting pieces.
std::vector<std::string> unionsToMake(const TriangleSoup& welded);

}  // namespace kerf::app

#pragma once

#include <string>
#include <vector>

#include "app/files/jobs/work_progress.h"
#include "sim/mesh/triangle_soup.h"

namespace kerf::app {

/// What became of pieces that cross.
struct ShellUnion {
    std::vector<std::string> done;  ///< "united 2 pieces that crossed", a phrase for each group
    std::vector<std::string> left;  ///< what is left as it is and why, a sentence each
};

/// Makes one surface of each group of pieces that cross each other: the boundary of all points that
/// lie in any of them. Lines of crossing are found with exact numbers and then rounded. What
/// crosses nothing else, and what can't be united, stays bit for bit. Colours, texture coordinates
/// and materials stay where they are. The soup must be one that can be cut. Runs the program
/// `kerf-unite`, within limits of time and memory; without it all is left. O(n log n). Throws
/// WorkCancelled.
ShellUnion uniteCrossingPieces(TriangleSoup& welded, WorkProgress* progress = nullptr);

/// What uniteCrossingPieces() would do: a clause for each group of pieces that cross.
std::vector<std::string> unionsToMake(const TriangleSoup& welded);

}  // namespace kerf::app

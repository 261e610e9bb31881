#pragma once

#include <functional>

#include "sim/cut/cut_types.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/mesh/triangle_finder.h"

namespace kerf::cut {

/// One search for the triangles near a strip.
struct CandidateSearch {
    const SurfaceMesh& mesh;  ///< the body
    TriangleFinder& finder;   ///< for CutSearch::tree
    CutSearch way;            ///< how to search
    OrientedBox reach;        ///< no triangle outside of it is near
    /// Whether a triangle is near. Each is asked once; what is near is to be kept by the function.
    std::function<bool(int)> isNear;
};

/// Asks about triangles until all that are near have been found, in an order that hangs on the way
/// of the search. The walk is the paper's algorithm A1 from its first seed on. That misses what
/// hangs together with no seed, such as a second arm: so the list of triangles is gone through to
/// its end for more seeds, and every group is found.
/// O(n) but for CutSearch::tree.
SearchWork searchCandidates(const CandidateSearch& search);

}  // namespace kerf::cut

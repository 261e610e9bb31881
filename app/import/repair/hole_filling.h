#pragma once

#include "sim/mesh/triangle_soup.h"

namespace kerf::app {

/// The outcome of fillHoles().
struct HoleFilling {
    int holes = 0;
    int triangles = 0;  ///< that were added
};

/// Borders with more edges stay open: the search takes O(edges^3).
inline constexpr int kMostHoleEdges = 500;

/// Closes each hole of a welded soup, a loop of edges that have one triangle, by the triangulation
/// of least area (Barequet and Sharir 1995) that repeats no edge and has no triangle without area.
/// Holes that touch in a vertex, are too large or cannot be triangulated so stay open.
HoleFilling fillHoles(TriangleSoup& welded);

}  // namespace kerf::app

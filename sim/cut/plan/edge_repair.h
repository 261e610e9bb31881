#pragma once

#include "sim/cut/plan/input/step.h"

namespace kerf::cut {

/// All half-edges that start at some vertices, one vertex after the other.
struct Umbrellas {
    std::vector<int> spokes;  ///< half-edges
    std::vector<int> ends;    ///< place in `spokes` behind the last one of each vertex
};

/// Whether two edges at one of these vertices have the same end points.
bool hasDuplicateEdges(const SurfaceMesh& mesh, const Umbrellas& umbrellas);

/// Keeps the mesh a simple complex (I3): where two edges have the same end points, copies are split
/// at their midpoints until one is left. Skin edges come first and alone; wall edges are split
/// together with their mirror copies, so that walls stay mirrored. Front edges stay. Looks at the
/// triangles from `firstTriangle` on; returns the older ones that it divided.
std::vector<int> splitDuplicateEdges(SurfaceMesh& mesh, int firstTriangle, int stroke,
                                     const std::set<Edge>& frontEdges);

}  // namespace kerf::cut

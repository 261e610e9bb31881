#pragma once

#include <set>
#include <vector>

#include "sim/cut/step.h"

namespace kerf::cut {

/// Whether two edges at the triangles from `firstTriangle` on have the same end points.
bool hasDuplicateEdges(const SurfaceMesh& mesh, int firstTriangle);

/// Keeps the mesh a simple complex (I3): where two edges have the same end points, copies are
/// split at their midpoints until one is left. Edges of the skin go first and alone; edges of
/// walls are split together with their mirror copies, so that walls stay mirrored. Front edges
/// stay. Looks at the triangles from `firstTriangle` on; returns the older ones that it divided.
std::vector<int> splitDuplicateEdges(SurfaceMesh& mesh, int firstTriangle, int stroke,
                                     const std::set<Edge>& frontEdges);

/// Splits the edge of half-edge h at its middle, both triangles into two. Returns the new vertex.
int splitEdgeAtMiddle(SurfaceMesh& mesh, int h);

}  // namespace kerf::cut

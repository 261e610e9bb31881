#pragma once

#include <utility>
#include <vector>

#include "sim/cut/cleanup/one_ring.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

// Piercings: places where the surface passes through itself or lies flat on itself, or where walls
// of a cut touch other surfaces elsewhere than in common corners. Looked for are pairs of triangles
// that share a vertex with each other or with a third one. Copies of a vertex count as one corner,
// so walls of a closed slit lie on each other and nothing more.

/// Triangles that get other corners: the slot and the new corners of each.
using ChangedTriangles = std::vector<std::pair<int, Triangle>>;

/// Whether after an operation more triangles pass through each other than before: a skin triangle
/// cut short over a wall that runs just below it, say.
bool addsPiercings(const SurfaceMesh& mesh, const std::vector<OneRing>& rings);
/// Whether after a change of corners more triangles pass through each other than before.
bool addsPiercings(const SurfaceMesh& mesh, const ChangedTriangles& changed);
/// Whether after a change of corners fewer triangles pass through each other than before.
bool removesPiercings(const SurfaceMesh& mesh, const ChangedTriangles& changed);

/// The slots of the triangles at the corners of t that t passes through, ascending.
std::vector<int> piercedNeighbours(const SurfaceMesh& mesh, int t);

}  // namespace kerf::cut

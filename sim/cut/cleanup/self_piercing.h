#pragma once

#include "sim/cut/cleanup/one_ring.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

// Piercings: places where the surface passes through itself or lies flat on itself, or where walls
// of a cut touch other surfaces elsewhere than in common corners. Looked for are pairs of triangles
// that share a vertex with each other or with a third one. Copies of a vertex count as one corner,
// so walls of a closed slit lie on each other and nothing more.

/// Triangles that get other corners: the slot and the new corners of each.
using ChangedTriangles = std::vector<std::pair<int, Triangle>>;

/// Whether an operation adds self-intersections, such as those of a skin triangle with a wall just
/// below it.
bool addsPiercings(const SurfaceMesh& mesh, const std::vector<OneRing>& rings);
/// Whether a change of corners adds self-intersections.
bool addsPiercings(const SurfaceMesh& mesh, const ChangedTriangles& changed);
/// Whether a change of corners removes self-intersections.
bool removesPiercings(const SurfaceMesh& mesh, const ChangedTriangles& changed);

/// The slots of the triangles at the corners of t that t intersects, ascending.
std::vector<int> piercedNeighbours(const SurfaceMesh& mesh, int t);

}  // namespace kerf::cut

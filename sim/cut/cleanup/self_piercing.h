#pragma once

#include <utility>
#include <vector>

#include "sim/cut/cleanup/local_patch.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

// Where the surface passes through itself or lies flat on itself, or where walls of a cut touch
// other surfaces elsewhere than in common corners: pairs of triangles that share a vertex with each
// other or with a third one. Copies of a material point count as one corner, so walls of a closed
// slit lie on each other and nothing more.

/// Triangles that get other corners: slots and corners.
using ChangedTriangles = std::vector<std::pair<int, Triangle>>;

/// Whether after an operation there are more such pairs than before: a skin triangle cut short
/// over a wall that runs just below it, say.
bool addsPiercings(const SurfaceMesh& mesh, const std::vector<Patch>& patches);
bool addsPiercings(const SurfaceMesh& mesh, const ChangedTriangles& changed);
/// Whether there are fewer.
bool removesPiercings(const SurfaceMesh& mesh, const ChangedTriangles& changed);

/// Slots of the triangles at the corners of t that it passes through, ascending.
std::vector<int> piercedNeighbours(const SurfaceMesh& mesh, int t);

}  // namespace kerf::cut

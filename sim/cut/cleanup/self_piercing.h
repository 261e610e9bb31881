#pragma once

#include <utility>
#include <vector>

#include "sim/cut/cleanup/patch.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// Whether an operation makes the surface pass through itself in a place where it does not yet: a
/// skin triangle cut short over a wall that runs just below it, say. New triangles are compared with each
/// other and with all that share a vertex with them. Copies of a material point count as one corner,
/// so walls of a closed slit lie on each other and nothing more.
bool piercesItself(const SurfaceMesh& mesh, const std::vector<Patch>& patches);

/// The same for triangles that get other corners (by slot, corners), no vertex moving.
bool piercesItself(const SurfaceMesh& mesh, const std::vector<std::pair<int, Triangle>>& changed);

}  // namespace kerf::cut

#pragma once

#include "sim/cut/cut_types.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// All triangles that a step added, removed or changed: ascending, each once.
std::vector<int> changedTriangles(const CutDelta& delta);

/// All vertices whose position, rest position or velocity a step set: new, moved and dead ones.
/// Ascending, each once.
std::vector<std::uint32_t> rewrittenVertices(const SurfaceMesh& mesh, const CutDelta& delta);

/// Records in `delta` that `triangles` and `vertices`, both ascending, were removed.
void noteRemoved(const std::vector<int>& triangles, const std::vector<int>& vertices,
                 CutDelta& delta);

}  // namespace kerf

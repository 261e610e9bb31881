#pragma once

#include "sim/cut/plan/curves/outline.h"
#include "sim/cut/plan/subdivide.h"

namespace kerf::cut {

/// The partner of a half-edge 3 * i + e of the new triangles: another one of them, or a remaining
/// half-edge of the mesh.
struct GluePartner {
    int newHalfEdge = -1;   ///< 3 * triangle + edge, -1 for none
    int meshHalfEdge = -1;  ///< half-edge of the mesh, -1 for none
};

/// Finds the partner of every new half-edge by a table. Topology comes only from it, never from
/// geometry; a missing or duplicate partner refuses the step (throws StepFailure). `triangles`: the
/// subdivision's, then W+, then W- with the same triangles turned over (the last two corners
/// exchanged).
std::vector<GluePartner> glue(const SurfaceMesh& mesh, const CutCurves& curves,
                              const Outline& outline, const Subdivision& subdivision,
                              const std::vector<NewTriangle>& triangles);

}  // namespace kerf::cut

#pragma once

#include "sim/cut/cut_types.h"
#include "sim/cut/plan/plan.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// The change that a step made to the mesh.
struct CommitResult {
    CutDelta delta;              ///< the change itself
    std::vector<RungNode> rung;  ///< the new rung's part, from A to B
    int splitVertices = 0;       ///< copies of vertices that were made
    std::vector<int> onSeams;    ///< new vertices on walls that were divided but not cut
};

/// Carries out a planned step. Cannot fail. The front edges of `staying` are not part of the step,
/// and stay. Every umbrella of the new surface becomes one vertex; the first one keeps the old
/// number, others become copies of it. `h`: edge length about the rung [m].
CommitResult commit(SurfaceMesh& mesh, const StepPlan& plan, double h, int stroke,
                    const std::vector<RungNode>& staying);

}  // namespace kerf::cut

#pragma once

#include "sim/cut/plan/step_plan.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// Whether both walls of every closed older slit stay each other's mirror in the step: the plan
/// divides both or neither, in copies of the same points. Slits count as closed where all copies of
/// their corners are within `closeDistance` [m]. Checks only the triangles that the step replaces.
bool keepsMirrors(const SurfaceMesh& mesh, const StepPlan& plan, double closeDistance);

}  // namespace kerf::cut

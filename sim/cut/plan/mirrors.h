#pragma once

#include "sim/cut/plan/step_plan.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// Whether both walls of every older slit that lies closed come out of the step as each other's
/// mirror: the plan divides both or neither, in copies of the same points. Slits count as closed
/// where all copies of their corners lie within `closeDistance` [m]. Looks at the triangles alone
/// that the step replaces.
bool keepsMirrors(const SurfaceMesh& mesh, const StepPlan& plan, double closeDistance);

}  // namespace kerf::cut

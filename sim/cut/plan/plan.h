#pragma once

#include "sim/cut/plan/step_plan.h"

namespace kerf::cut {

/// One try of a step, without touching the mesh.
struct PlannedStep {
    bool air = false;       ///< the blade swept no material: the rung moves on, nothing else
    StepPlan plan;          ///< the cut; for a step in the air only the ends of the new rung
    int wallTriangles = 0;  ///< new wall triangles, both sides
    SweptArea swept;        ///< inside of the material
    int seeds = 0;          ///< groups of touched triangles (countSeeds)
};

/// Plans one step. Throws StepFailure if this attempt has no valid result.
PlannedStep planStep(const StepInput& in);

}  // namespace kerf::cut

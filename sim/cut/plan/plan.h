#pragma once

#include <optional>
#include <vector>

#include "sim/cut/plan/step_plan.h"

namespace kerf::cut {

/// A step in which the blade swept no material: the rung moves on, nothing else.
struct AirStep {
    RungNode endA;  ///< the new rung's end at A
    RungNode endB;  ///< the new rung's end at B
};

/// One try of a step, without touching the mesh.
struct PlannedStep {
    std::optional<AirStep> air;  ///< set where nothing is to be cut
    StepPlan plan;               ///< the cut; means nothing where `air` is set
    int wallTriangles = 0;       ///< new wall triangles, both sides
    SweptArea swept;             ///< inside of the material
    int seeds = 0;               ///< groups of touched triangles (countSeeds)
};

/// Plans one step. Throws StepFailure where no valid result comes out of this attempt.
PlannedStep planStep(const StepInput& in);

}  // namespace kerf::cut

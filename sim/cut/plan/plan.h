#pragma once

#include <optional>
#include <vector>

#include "sim/cut/plan/step_plan.h"

namespace kerf::cut {

/// The blade swept no material: the rung moves on, nothing else.
struct AirStep {
    RungNode endA;
    RungNode endB;
};

/// One try of a step, without touching the mesh.
struct PlannedStep {
    std::optional<AirStep> air;
    StepPlan plan;  ///< without `air`
    int wallTriangles = 0;
    int seeds = 0;  ///< see countSeeds
};

/// Plans one step. Throws StepFailure where no valid result comes out of this attempt.
PlannedStep planStep(const StepInput& in);

}  // namespace kerf::cut

#pragma once

#include "sim/cut/plan/glue.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// A complete step, ready to be carried out.
struct StepPlan {
    CutCurves curves;                    ///< curves in which strip and surface meet; all new nodes
    Outline outline;                     ///< border of the new wall
    Subdivision subdivision;             ///< triangles that replace those of the surface
    std::vector<NewTriangle> triangles;  ///< surface first, then W+, then W-
    std::vector<GluePartner> partners;   ///< partner by 3 * triangle + edge
    RungNode endA;                       ///< the new rung's end at A, where that is in the air
    RungNode endB;                       ///< the new rung's end at B, where that is in the air
    bool retraces = false;               ///< the blade runs along an older slit
    double volumeChange = 0;             ///< change of the current volume, before rounding [m^3]
    double restVolumeChange = 0;         ///< change of the rest volume, before rounding [m^3]
};

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

/// Whether both walls of every closed older slit stay each other's mirror in the step: the plan
/// divides both or neither, in copies of the same points. Slits count as closed where all copies of
/// their corners are within `closeDistance` [m]. Checks only the triangles that the step replaces.
bool keepsMirrors(const SurfaceMesh& mesh, const StepPlan& plan, double closeDistance);

}  // namespace kerf::cut

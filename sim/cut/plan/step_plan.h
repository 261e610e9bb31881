#pragma once

#include <vector>

#include "sim/cut/plan/glue.h"

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

}  // namespace kerf::cut

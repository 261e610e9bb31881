#pragma once

#include <vector>

#include "sim/cut/plan/glue.h"

namespace kerf::cut {

/// A complete step, ready to be carried out.
struct StepPlan {
    CutCurves curves;
    Outline outline;
    Subdivision subdivision;
    std::vector<NewTriangle> triangles;  ///< surface first, then W+, then W-
    std::vector<GluePartner> partners;   ///< by 3 * triangle + edge
    RungNode endA;                       ///< the ends of the new rung, in the air
    RungNode endB;
    bool retraces = false;        ///< the blade runs along an older slit
    double volumeChange = 0;      ///< signed, before rounding [m^3]
    double restVolumeChange = 0;  ///< the same of the rest shape
};

}  // namespace kerf::cut

#pragma once

#include "sim/base/math.h"

namespace kerf {

/// The mean load of a body on the blade over a time step.
struct BladeLoad {
    Vec3 force = Vec3::Zero();  ///< [N]
    /// About the middle of the plate behind the bevel; without a plate, of the commanded edge [N
    /// m].
    Vec3 moment = Vec3::Zero();
};

/// The resistance of the material against the edge after a time step, with `blade_feels`.
struct HeldEdge {
    double lag = 0;     ///< mean lag of the edge behind its command [m]
    double energy = 0;  ///< in the spring between both [J]
    double work = 0;    ///< of the blade in the step, against the edge only [J]
};

}  // namespace kerf

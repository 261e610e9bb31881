#pragma once

#include "sim/base/math.h"

namespace kerf {

/// What a body did to the body of the blade, as a mean over a time step.
struct BladeLoad {
    Vec3 force = Vec3::Zero();  ///< [N]
    /// About the middle of the plate behind the bevel; without a plate of the edge as it is led
    /// [N m].
    Vec3 moment = Vec3::Zero();
};

/// How the material holds the edge of a blade back that feels it, after a time step.
struct HeldEdge {
    double lag = 0;     ///< of the edge behind where it is led, a mean [m]
    double energy = 0;  ///< in the spring between both [J]
    double work = 0;    ///< of what led the blade in the step, against the edge alone [J]
};

}  // namespace kerf

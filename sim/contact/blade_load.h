#pragma once

#include "sim/base/math.h"

namespace kerf {

/// What a body did to the body of the blade, as a mean over a time step.
struct BladeLoad {
    Vec3 force = Vec3::Zero();   ///< [N]
    Vec3 moment = Vec3::Zero();  ///< about the middle of the plate behind the bevel [N m]
};

}  // namespace kerf

#pragma once

#include <array>

#include "sim/base/math.h"

namespace kerf::ui {

/// The world's axes in the view: x to the right, y up, z towards the viewer; unit.
struct ViewAxes {
    std::array<Vec3, 3> axes{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
};

}  // namespace kerf::ui

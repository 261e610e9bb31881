#pragma once

#include <array>
#include <vector>

#include "sim/base/math.h"
#include "ui/action.h"
#include "ui/layout.h"

namespace kerf::ui {

/// The world's axes as the view shows them: x to the right, y up, z towards the viewer; unit.
struct ViewAxes {
    std::array<Vec3, 3> axes{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
};

/// A small cross of the world's axes in the upper right corner of the view. A click on one of its
/// six ends looks from there. `scale` is the display's
/// (1 = 96 dpi).
void drawAxes(const ViewAxes& axes, const Rect& view, float scale, std::vector<Action>& actions);

}  // namespace kerf::ui

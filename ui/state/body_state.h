#pragma once

#include <cstddef>
#include <vector>

#include "sim/contact/static_box.h"

namespace kerf::ui {

/// The state of the body for several panels.
struct BodyState {
    double size = 1;               ///< its diagonal at rest [m]
    Bounds bounds;                 ///< at present [m]
    std::vector<StaticBox> boxes;  ///< that it collides with
    int vertices = 0;
    int triangles = 0;
    std::size_t pinned = 0;  ///< pinned vertices and forces
    std::size_t hooks = 0;   ///< of retractors, which hold cuts open
};

}  // namespace kerf::ui

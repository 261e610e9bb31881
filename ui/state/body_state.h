#pragma once

#include <cstddef>
#include <vector>

#include "sim/contact/static_box.h"

namespace kerf::ui {

/// What several panels show of the body.
struct BodyState {
    double size = 1;               ///< its diagonal at rest [m]
    Bounds bounds;                 ///< as it is [m]
    std::vector<StaticBox> boxes;  ///< that it collides with
    int vertices = 0;
    int triangles = 0;
    std::size_t pinned = 0;  ///< vertices that are held in place
    std::size_t hooks = 0;   ///< of retractors, which hold cuts open
};

}  // namespace kerf::ui

#pragma once

#include "sim/base/math.h"

namespace kerf::render {

/// A plane that the picture of the body is cut open by. The body itself knows nothing of it.
struct SectionPlane {
    Vec3 point = Vec3::Zero();    ///< on the plane [m]
    Vec3 normal = Vec3::UnitZ();  ///< unit; the body is hidden where it points to
    bool operator==(const SectionPlane&) const = default;

    /// How far a point lies on the side that is hidden [m]; negative on the other.
    double distance(const Vec3& at) const { return normal.dot(at - point); }
};

}  // namespace kerf::render

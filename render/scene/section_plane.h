#pragma once

#include "sim/base/math.h"

namespace kerf::render {

/// A plane that opens the view of the body, without cutting it.
struct SectionPlane {
    Vec3 point = Vec3::Zero();    ///< on the plane [m]
    Vec3 normal = Vec3::UnitZ();  ///< unit; the body is hidden on its side
    bool operator==(const SectionPlane&) const = default;

    /// The distance of a point on the hidden side [m]; negative on the other.
    double distance(const Vec3& at) const { return normal.dot(at - point); }
};

}  // namespace kerf::render

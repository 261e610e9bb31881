#pragma once

#include <variant>

#include "sim/base/math.h"

namespace kerf {

/// All points within `radius` of `center` [m].
struct Ball {
    Vec3 center = Vec3::Zero();
    double radius = 0;
};

/// A part of space: that of a brush or a box.
using Region = std::variant<Ball, Bounds>;

inline bool contains(const Region& region, const Vec3& p) {
    if (const auto* ball = std::get_if<Ball>(&region)) {
        return (p - ball->center).squaredNorm() <= ball->radius * ball->radius;
    }
    const Bounds& box = std::get<Bounds>(region);
    return (p.array() >= box.low.array()).all() && (p.array() <= box.high.array()).all();
}

}  // namespace kerf

#pragma once

#include <limits>

#include "sim/mesh/line_hit.h"
#include "sim/mesh/triangle.h"
#include "sim/mesh/winding.h"

namespace kerf {

/// A point inside of a closed shell and how far it lies behind the surface [m], 0 on it.
struct InnerPoint {
    Vec3 point;
    double depth = 0;
};

/// The point half way through a shell from the middle of one of its triangles, `at`. It lies off
/// surfaces that touch the shell. `inward`: 1 where the triangles face outward, -1 where inward.
/// `forEach(f)` calls f with the corners of each triangle of the shell. O(n).
template <class ForEach>
InnerPoint pointBehind(const Corners& at, int inward, ForEach&& forEach) {
    constexpr double kItself = 1e-9;  // of the triangle's size
    constexpr double kGrazing = 1e-9;
    const Vec3 origin = pointInside(at);
    const Vec3 direction = -inward * areaNormal(at).stableNormalized();
    const double least = kItself * longestEdge(at);
    double nearest = std::numeric_limits<double>::infinity();
    forEach([&](const Corners& other) {
        const auto hit = hitOf(other, origin, direction, kGrazing);
        if (hit && hit->distance > least && hit->distance < nearest) {
            nearest = hit->distance;
        }
    });
    if (nearest == std::numeric_limits<double>::infinity()) {
        return {origin, 0};
    }
    return {origin + nearest / 2 * direction, nearest / 2};
}

}  // namespace kerf

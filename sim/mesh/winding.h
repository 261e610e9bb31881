#pragma once

#include <algorithm>

#include "sim/mesh/triangle.h"

namespace kerf {

namespace winding {

/// Which side of the line through a and b the point lies on, seen along x. Both triangles of an
/// edge get opposite answers, so that a ray meets one of them.
inline int sideOf(const Vec3& a, int idA, const Vec3& b, int idB, const Vec3& point) {
    const Vec3 from = (idA < idB ? a : b) - point;
    const Vec3 to = (idA < idB ? b : a) - point;
    const int side = from.y() * to.z() - from.z() * to.y() >= 0 ? 1 : -1;
    return idA < idB ? side : -side;
}

inline bool mayCross(const Corners& at, const Vec3& point) {
    const auto spans = [&](int axis) {
        const auto [low, high] = std::minmax({at[0][axis], at[1][axis], at[2][axis]});
        return low <= point[axis] && point[axis] <= high;
    };
    return spans(1) && spans(2) && std::max({at[0].x(), at[1].x(), at[2].x()}) >= point.x();
}

}  // namespace winding

/// 1 where the ray from `point` along x leaves a body through the triangle, -1 where it enters, 0
/// where it passes by. Summed over a closed surface it is how often that surrounds the point.
/// `ids`: the vertices, so that triangles with a common edge agree about it.
inline int rayCrossing(const Corners& at, const Triangle& ids, const Vec3& point) {
    if (!winding::mayCross(at, point)) {
        return 0;
    }
    const auto side = [&](int i, int k) {
        return winding::sideOf(at[i], ids[i], at[k], ids[k], point);
    };
    const int turn = side(0, 1);
    if (turn != side(1, 2) || turn != side(2, 0)) {
        return 0;
    }
    const double behind = areaNormal(at).dot(point - at[0]);
    return turn * behind < 0 ? turn : 0;
}

/// A point in the triangle that edges of a regular mesh are hardly ever in line with.
inline Vec3 pointInside(const Corners& at) {
    constexpr double kFirst = 0.3149;
    constexpr double kSecond = 0.3373;
    return kFirst * at[0] + kSecond * at[1] + (1 - kFirst - kSecond) * at[2];
}

/// Whether the point lies in the box or on it.
inline bool contains(const Bounds& bounds, const Vec3& point) {
    return (bounds.low.array() <= point.array()).all() &&
           (point.array() <= bounds.high.array()).all();
}

}  // namespace kerf

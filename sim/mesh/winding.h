#pragma once

#include "sim/base/predicates.h"
#include "sim/mesh/box_tree.h"
#include "sim/mesh/triangle.h"

namespace kerf {

// Rays run along x. The point is thought of as moved by a hair along y, less along z and least
// along x, so that its ray meets no edge and no plane that it lies in (simulation of simplicity,
// Edelsbrunner and Muecke 1990). All signs are exact, so that triangles agree about their edges and
// vertices.
namespace winding {

/// The sign of a determinant for the perturbed point: that of its first nonzero term.
inline int firstSign(int sign, double then, double last) {
    const auto signOf = [](double value) { return value > 0 ? 1 : value < 0 ? -1 : 0; };
    const int second = sign != 0 ? sign : signOf(then);
    return second != 0 ? second : signOf(last);
}

/// The side of the line through a and b that the point is on, seen along x; 0 where a hides b.
inline int sideOf(const Vec3& a, const Vec3& b, const Vec3& point) {
    const int sign = orient2d({a.y(), a.z()}, {b.y(), b.z()}, {point.y(), point.z()});
    return firstSign(sign, a.z() - b.z(), b.y() - a.y());
}

inline bool mayCross(const Corners& at, const Vec3& point) {
    const auto spans = [&](int axis) {
        const auto [low, high] = std::minmax({at[0][axis], at[1][axis], at[2][axis]});
        return low <= point[axis] && point[axis] <= high;
    };
    return spans(1) && spans(2) && std::max({at[0].x(), at[1].x(), at[2].x()}) >= point.x();
}

/// On which side of a triangle's plane the point lies, 1 where the triangle faces it. `facing`: the
/// sign of the normal along x, not 0.
inline int sideOfPlane(const Corners& at, int facing, const Vec3& point) {
    const auto& [a, b, c] = at;
    const int sign = orientSign3d(a, b, c, point);
    if (sign != 0) {
        return sign;
    }
    const int alongY = orient2d({a.z(), a.x()}, {b.z(), b.x()}, {c.z(), c.x()});
    const int alongZ = orient2d({a.x(), a.y()}, {b.x(), b.y()}, {c.x(), c.y()});
    return firstSign(alongY, alongZ, facing);
}

}  // namespace winding

/// 1 if the ray from `point` along x leaves a body through the triangle, -1 if it enters, 0 if it
/// misses. Summed over a closed surface it is the winding number of the point. A point on the
/// surface counts for one side.
inline int rayCrossing(const Corners& at, const Vec3& point) {
    if (!winding::mayCross(at, point)) {
        return 0;
    }
    const int turn = winding::sideOf(at[0], at[1], point);
    if (turn == 0 || turn != winding::sideOf(at[1], at[2], point) ||
        turn != winding::sideOf(at[2], at[0], point)) {
        return 0;
    }
    return winding::sideOfPlane(at, turn, point) == -turn ? turn : 0;
}

/// A point in the triangle that is rarely collinear with edges of a regular mesh.
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

/// A point inside a closed shell and its depth below the surface [m], 0 on it.
struct InnerPoint {
    Vec3 point;
    double depth = 0;
};

/// The point half way through a shell from the middle of one of its triangles, `at`. It is not on
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

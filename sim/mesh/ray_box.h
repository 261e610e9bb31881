#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/base/math.h"
#include "sim/mesh/triangle.h"

namespace kerf {

/// A ray for box tests. `direction` need not have length 1; along an axis without motion the ray
/// passes if it starts between the box's sides.
struct BoxRay {
    BoxRay(const Vec3& from, const Vec3& along) : origin(from), direction(along) {
        for (int axis = 0; axis < 3; ++axis) {
            inverse[axis] = along[axis] != 0 ? 1 / along[axis] : 1e200;
        }
    }
    Vec3 origin, direction, inverse;
};

inline constexpr double kMissesBox = 1e301;

/// The place where the ray enters the box, in lengths of its direction, at least 0; kMissesBox if
/// it does not before `farthest`. Shares of the ray between the planes of each axis (Kay and Kajiya
/// 1986).
inline double entryInto(const Bounds& box, const BoxRay& ray, double farthest) {
    const Vec3 toLow = (box.low - ray.origin).cwiseProduct(ray.inverse);
    const Vec3 toHigh = (box.high - ray.origin).cwiseProduct(ray.inverse);
    const double enter = std::max(0.0, toLow.cwiseMin(toHigh).maxCoeff());
    const double leave = std::min(farthest, toLow.cwiseMax(toHigh).minCoeff());
    return enter <= leave ? enter : kMissesBox;
}

/// Where a line meets a triangle, from either side.
struct LineHit {
    double distance = 0;  ///< along the direction, in its lengths; below 0 behind the origin
    double b1 = 0;        ///< weight of the second corner
    double b2 = 0;        ///< of the third one
};

/// Share of their edges by which triangles extend beyond their border, so that no line passes
/// between two.
inline constexpr double kHitBorder = 2e-5;

/// Möller and Trumbore (1997), with a border that is widened by kHitBorder. None for a line that
/// lies in the plane of the triangle to a cosine of `leastCosine`.
inline std::optional<LineHit> hitOf(const Corners& corners, const Vec3& origin,
                                    const Vec3& direction, double leastCosine) {
    const Vec3 e1 = corners[1] - corners[0];
    const Vec3 e2 = corners[2] - corners[0];
    const Vec3 p = direction.cross(e2);
    const double determinant = e1.dot(p);
    const double scale = e1.cross(e2).norm() * direction.norm();
    if (std::abs(determinant) <= leastCosine * scale) {
        return std::nullopt;
    }
    const Vec3 s = origin - corners[0];
    const Vec3 q = s.cross(e1);
    const double b1 = s.dot(p) / determinant;
    const double b2 = direction.dot(q) / determinant;
    if (b1 < -kHitBorder || b2 < -kHitBorder || b1 + b2 > 1 + kHitBorder) {
        return std::nullopt;
    }
    return LineHit{e2.dot(q) / determinant, b1, b2};
}

}  // namespace kerf

#pragma once

#include "sim/base/math.h"

namespace kerf {

/// A determinant: its exact sign, and its value as far as doubles carry it.
struct Orientation {
    int sign = 0;      ///< -1, 0 or 1
    double value = 0;  ///< rounded; its sign may be wrong
};

/// The determinant ((b - a) x (c - a)) . (p - a), six times a signed volume: positive where p lies
/// on the side that the normal of abc points to. A static filter decides almost every call; the
/// rest is evaluated with expansions (Shewchuk 1997). Needs -ffp-contract=off.
Orientation orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p);

/// The estimate of a determinant in doubles.
struct Estimate3d {
    double determinant;  ///< its rounded value
    double magnitude;    ///< the sum of the sizes of its terms
    /// The sign of the determinant, 0 where doubles do not tell. The error bound is (7 + 56 e) e
    /// with e = 2^-53, rounded up.
    int sign() const {
        const double error = 8e-16 * magnitude;
        return determinant > error ? 1 : determinant < -error ? -1 : 0;
    }
};

/// The estimate of orient3d's determinant.
inline Estimate3d estimate3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
    const double ux = b.x() - a.x(), uy = b.y() - a.y(), uz = b.z() - a.z();
    const double vx = c.x() - a.x(), vy = c.y() - a.y(), vz = c.z() - a.z();
    const double wx = p.x() - a.x(), wy = p.y() - a.y(), wz = p.z() - a.z();
    const double yz = uy * vz, zy = uz * vy, zx = uz * vx, xz = ux * vz, xy = ux * vy, yx = uy * vx;
    const double determinant = (yz - zy) * wx + (zx - xz) * wy + (xy - yx) * wz;
    const double magnitude = (std::fabs(yz) + std::fabs(zy)) * std::fabs(wx) +
                             (std::fabs(zx) + std::fabs(xz)) * std::fabs(wy) +
                             (std::fabs(xy) + std::fabs(yx)) * std::fabs(wz);
    return {determinant, magnitude};
}

/// The exact sign of orient3d where estimate3d does not tell it: twice the precision decides most,
/// expansions the rest. `magnitude`: Estimate3d's.
int preciseSign3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p, double magnitude);

/// The sign of orient3d alone, at a fraction of the time where p lies almost in the plane.
inline int orientSign3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
    const Estimate3d estimate = estimate3d(a, b, c, p);
    const int sign = estimate.sign();
    return sign != 0 ? sign : preciseSign3d(a, b, c, p, estimate.magnitude);
}

/// The exact sign of orient2d where its filter does not tell it.
int exactOrient2d(const Vec2& a, const Vec2& b, const Vec2& c);

/// The exact sign of twice the signed area of abc: +1 where it runs counter-clockwise.
inline int orient2d(const Vec2& a, const Vec2& b, const Vec2& c) {
    const double left = (b.x() - a.x()) * (c.y() - a.y());
    const double right = (b.y() - a.y()) * (c.x() - a.x());
    // The error bound is (3 + 16 e) e, rounded up.
    const double error = 3.4e-16 * (std::fabs(left) + std::fabs(right));
    const double area = left - right;
    return area > error ? 1 : area < -error ? -1 : exactOrient2d(a, b, c);
}

/// The lexicographic order of two points; where they coincide, the order of their ids. Copies then
/// give their arguments in the same order and get bit-identical results.
bool comesBefore(const Vec3& p, int idP, const Vec3& q, int idQ);

}  // namespace kerf

#pragma once

#include "sim/math.h"

namespace kerf::cut {

/// Sign of a determinant, exact, and its value as far as doubles carry it.
struct Orientation {
    int sign = 0;
    double value = 0;
};

/// Of ((b - a) x (c - a)) . (p - a), six times a signed volume: positive where p lies on the side
/// that the normal of abc points to. A static filter decides almost every call; the rest is
/// evaluated with expansions (Shewchuk 1997). Needs -ffp-contract=off.
Orientation orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p);

/// Its sign alone, at a fraction of the time where p lies almost in the plane: twice the precision
/// decides most of what the filter leaves.
int orientSign3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p);

/// Exact sign of twice the signed area of abc: +1 where it runs counter-clockwise.
int orient2d(const Vec2& a, const Vec2& b, const Vec2& c);

/// Lexicographic order of two points; where they coincide, the order of their ids. Mates then
/// give their arguments in the same order and get bit-identical results.
bool comesBefore(const Vec3& p, int idP, const Vec3& q, int idQ);

}  // namespace kerf::cut

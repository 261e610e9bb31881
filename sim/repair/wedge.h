#pragma once

#include "sim/base/math.h"

namespace kerf::repair {

/// A straight line, by two different points of it.
struct Line {
    Vec3 u;
    Vec3 v;
};

/// The material between the two faces that meet in a line, each given by a point beside the line.
/// Seen with u -> v towards the eye, the material is counter-clockwise from the face at `from` to
/// the face at `to`. Of a closed surface with u -> v as an edge, `to` is the apex of the triangle
/// that runs from u to v, and `from` that of the one that runs back.
struct Wedge {
    Vec3 from;
    Vec3 to;
};

/// Whether a point lies on a line: exact.
bool isOn(const Line& line, const Vec3& p);

/// Whether two surfaces that meet along a line cross there, or share a face with their material on
/// the same side of it: exact. False if they only touch, from outside or inside, and if both faces
/// of a wedge are one.
bool wedgesCross(const Line& line, const Wedge& a, const Wedge& b);

/// An axis along which a triangle can be projected, -1 if it has no area: exact.
int axisToLeaveOut(const Vec3& a, const Vec3& b, const Vec3& c);

/// A point without one of its coordinates.
Vec2 without(int axis, const Vec3& p);

}  // namespace kerf::repair

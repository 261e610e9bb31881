#pragma once

#include "sim/base/math.h"

namespace kerf::repair {

/// A straight line, by two different points of it.
struct Line {
    Vec3 u;
    Vec3 v;
};

/// The material between the two faces that meet in a line, each known by a point of it beside the
/// line. Seen with u -> v towards the eye, the material lies counter-clockwise from the face at
/// `from` to the face at `to`. Of a closed surface with u -> v as an edge, `to` is the apex of the
/// triangle that runs from u to v, and `from` that of the one that runs back.
struct Wedge {
    Vec3 from;
    Vec3 to;
};

/// Whether a point lies on a line: exact.
bool isOn(const Line& line, const Vec3& p);

/// Whether two surfaces that meet along a line pass through each other there, or have a face in
/// common with their material on the same side of it: exact. False where they only touch, from
/// outside or from within, and where both faces of a wedge are one.
bool wedgesCross(const Line& line, const Wedge& a, const Wedge& b);

/// The axis that can be left out to look at a triangle from its side, -1 where it has no area:
/// exact.
int axisToLeaveOut(const Vec3& a, const Vec3& b, const Vec3& c);

/// A point without one of its coordinates.
Vec2 without(int axis, const Vec3& p);

}  // namespace kerf::repair

#include "sim/repair/wedge.h"

#include "sim/base/predicates.h"

namespace kerf::repair {

namespace {

/// How far a direction about a line is turned from another one, counter-clockwise.
enum class Turn { none, lessThanHalf, half, moreThanHalf };

/// Where a face lies in the directions about a line, as a wedge divides them.
enum class Sector { within, outside, onFrom, onTo };

/// Compares the half-planes that begin at a line, each known by a point of it.
class AroundLine {
  public:
    explicit AroundLine(const Line& line) : line_(line) {}

    Sector sectorOf(const Vec3& face, const Wedge& wedge) const {
        if (turn(wedge.from, face) == Turn::none) {
            return Sector::onFrom;
        }
        if (turn(wedge.to, face) == Turn::none) {
            return Sector::onTo;
        }
        return comesFirst(wedge.from, face, wedge.to) ? Sector::within : Sector::outside;
    }
    bool isFlat(const Wedge& wedge) const {
        return isOn(line_, wedge.from) || isOn(line_, wedge.to) ||
               turn(wedge.from, wedge.to) == Turn::none;
    }

  private:
    int side(const Vec3& a, const Vec3& b) const { return orientSign3d(line_.u, line_.v, a, b); }

    Turn turn(const Vec3& start, const Vec3& face) const {
        const int sign = side(start, face);
        if (sign != 0) {
            return sign > 0 ? Turn::lessThanHalf : Turn::moreThanHalf;
        }
        const int axis = axisToLeaveOut(line_.u, line_.v, start);
        const auto sideInPlane = [&](const Vec3& p) {
            return orient2d(without(axis, line_.u), without(axis, line_.v), without(axis, p));
        };
        return sideInPlane(start) == sideInPlane(face) ? Turn::none : Turn::half;
    }

    /// Whether a is met before b, counter-clockwise from the start.
    bool comesFirst(const Vec3& start, const Vec3& a, const Vec3& b) const {
        const Turn toA = turn(start, a);
        const Turn toB = turn(start, b);
        const bool oneHalf = toA == Turn::lessThanHalf || toA == Turn::moreThanHalf;
        return toA != toB ? toA < toB : oneHalf && side(a, b) > 0;
    }

    const Line& line_;
};

/// Whether the faces of b say so: one has its material where a has it too, or just one lies in a.
bool facesCross(const AroundLine& around, const Wedge& a, const Wedge& b) {
    const Sector from = around.sectorOf(b.from, a);
    const Sector to = around.sectorOf(b.to, a);
    if (from == Sector::onFrom || to == Sector::onTo) {
        return true;
    }
    return (from == Sector::within) != (to == Sector::within);
}

}  // namespace

bool isOn(const Line& line, const Vec3& p) {
    return axisToLeaveOut(line.u, line.v, p) < 0;
}

bool wedgesCross(const Line& line, const Wedge& a, const Wedge& b) {
    const AroundLine around(line);
    if (around.isFlat(a) || around.isFlat(b)) {
        return false;
    }
    return facesCross(around, a, b) || facesCross(around, b, a);
}

int axisToLeaveOut(const Vec3& a, const Vec3& b, const Vec3& c) {
    for (int axis = 0; axis < 3; ++axis) {
        if (orient2d(without(axis, a), without(axis, b), without(axis, c)) != 0) {
            return axis;
        }
    }
    return -1;
}

Vec2 without(int axis, const Vec3& p) {
    return {p[(axis + 1) % 3], p[(axis + 2) % 3]};
}

}  // namespace kerf::repair

#pragma once

#include "sim/base/math.h"

namespace kerf {

/// A box along any axes.
struct OrientedBox {
    Vec3 center = Vec3::Zero();
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns, orthonormal
    Vec3 half = Vec3::Zero();                            ///< half the size along each axis [m]

    /// Moves every side outwards.
    void widen(double margin) { half.array() += margin; }
};

/// The box of some points (at least one) along the principal axes of their spread.
OrientedBox orientedBoxOf(std::span<const Vec3> points);

/// The box about some points (at least one) along given axes (columns, orthonormal).
OrientedBox orientedBoxAlong(const Eigen::Matrix3d& axes, std::span<const Vec3> points);

/// No point of `inner` lies outside `outer`.
bool contains(const OrientedBox& outer, const OrientedBox& inner);

/// False if an axis of either box separates them; cheaper than overlap().
bool mayMeet(const OrientedBox& a, const Bounds& b);

/// mayMeet() for many boxes against one, at a fraction of the time for each. Boxes that it finds
/// may be apart by rounding.
class MeetingBoxes {
  public:
    explicit MeetingBoxes(const OrientedBox& box);

    bool mayMeet(const Bounds& b) const {
        return b.overlaps(around_) &&
               meetsAlongAxes(0.5 * (b.low + b.high), 0.5 * (b.high - b.low));
    }

  private:
    bool meetsAlongAxes(const Vec3& center, const Vec3& half) const;

    Bounds around_;           ///< of the box; separates most
    Eigen::Matrix3d axes_;    ///< rows
    Eigen::Matrix3d across_;  ///< sizes of their entries
    Vec3 middle_;             ///< of the box, along its axes
    Vec3 half_;               ///< of its size, with room for rounding
};

/// Whether two boxes have a point in common: none of the 15 axes that can separate boxes does
/// (Gottschalk, Lin, Manocha 1996). Boxes that touch overlap, up to rounding.
bool overlap(const OrientedBox& a, const OrientedBox& b);

}  // namespace kerf

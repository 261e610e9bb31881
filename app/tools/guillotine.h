#pragma once

#include <Eigen/Core>

#include "sim/base/math.h"
#include "sim/cut/blade.h"

namespace kerf::app {

/// A posed blade above the body and its straight path down.
class Guillotine {
  public:
    /// The points by which the pointer poses the blade.
    enum Handle { middle, endA, endB, bottom };
    static constexpr int kHandles = 4;

    Guillotine() = default;
    /// A blade across the middle of `bounds`, from above it to below it.
    explicit Guillotine(const Bounds& bounds);

    /// The blade at the share `lowered` of its path, 0 to 1.
    Blade at(double lowered) const;
    double length() const { return 2 * halfLength_; }
    double drop() const { return drop_; }
    void setLength(double length) { halfLength_ = 0.5 * length; }
    void setDrop(double drop) { drop_ = drop; }

    /// Positions of the handles [m]. The middle moves the blade, the ends turn and lengthen it
    /// about its middle, the bottom one turns its path about the blade and sets its length.
    std::array<Vec3, kHandles> handles() const;
    void move(Handle handle, const Vec3& to);

    /// The blade's middle at the top [m].
    const Vec3& center() const { return center_; }
    /// Columns, unit: from A to B, upwards, and across both.
    Eigen::Matrix3d axes() const;
    /// This blade, turned about its middle and moved.
    Guillotine moved(const Vec3& by, const Eigen::Matrix3d& turn) const;

  private:
    void turnTo(const Vec3& along);

    Vec3 center_ = Vec3::Zero();  ///< at the top
    Vec3 along_ = Vec3::UnitX();  ///< unit, from A to B
    Vec3 down_ = -Vec3::UnitY();  ///< unit, square to it
    double halfLength_ = 0.5;     ///< [m]
    double drop_ = 1;             ///< [m]
};

}  // namespace kerf::app

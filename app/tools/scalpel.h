#pragma once

#include "app/scene/readout/cut_preview.h"
#include "sim/cut/blade.h"

namespace kerf::app {

/// Moves a blade over the surface, upright. It enters the skin at the first point, and goes deeper
/// on its way from there until it is a set depth below the surface.
class Scalpel {
  public:
    /// A scalpel that goes `depth` below the surface [m].
    explicit Scalpel(double depth) : depth_(depth) {}

    /// The poses to another point of the surface, in order; none until the first two points are far
    /// enough apart to define the direction.
    std::vector<Blade> moveTo(const SurfacePoint& point);
    /// The blade, upright at a point of the surface.
    Blade at(const SurfacePoint& point) const { return at(point, depth_); }
    /// From the next point on it goes to another depth [m].
    void setDepth(double depth) { depth_ = depth; }

  private:
    Blade at(const SurfacePoint& point, double depth) const;
    double lift() const { return kLift * depth_; }
    double wayIn() const { return kWayIn * depth_; }

    static constexpr double kLift = 0.4;    ///< part above the surface, as a share of the depth
    static constexpr double kAbove = 0.02;  ///< of its tip over the first point, of the depth
    static constexpr double kTell = 0.15;   ///< least way that has a direction, of the depth
    static constexpr double kWayIn = 0.5;   ///< on which it reaches the depth, as a share of it

    double depth_;
    std::optional<SurfacePoint> last_;
    double way_ = 0;  ///< from the first point [m]
};

}  // namespace kerf::app

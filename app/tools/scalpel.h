#pragma once

#include "app/scene/readout/cut_preview.h"
#include "sim/cut/blade.h"

namespace kerf::app {

/// Moves a blade over the surface: upright, a set depth below it. It swings in from the air above,
/// so that it enters the skin edge first.
class Scalpel {
  public:
    /// A scalpel that goes `depth` below the surface [m].
    explicit Scalpel(double depth) : depth_(depth) {}

    /// The poses to another point of the surface, in order; none until the first two points are far
    /// enough apart to define the direction.
    std::vector<Blade> moveTo(const SurfacePoint& point);
    /// The blade, upright at a point of the surface.
    Blade at(const SurfacePoint& point) const;

  private:
    double lift() const { return kLift * depth_; }

    static constexpr double kLift = 0.4;   ///< part above the surface, as a share of the depth
    static constexpr double kTell = 0.15;  ///< least way that has a direction, of the depth

    double depth_;
    std::optional<SurfacePoint> first_;
    bool in_ = false;
};

}  // namespace kerf::app

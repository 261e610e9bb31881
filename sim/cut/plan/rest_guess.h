#pragma once

#include <Eigen/Core>

#include "sim/cut/plan/intersections.h"

namespace kerf::cut {

/// Roughly where a place of the strip inside the body rests, for looking up edge lengths: by the
/// affine map that fits the curves and the old front best. Where new wall vertices rest is another
/// matter (mapFromSkin).
class RestGuess {
  public:
    RestGuess(const StepInput& in, const Strip& strip, const CutCurves& curves);
    Vec3 at(const Vec3& position) const {
        return position + offset_ + change_ * (position - center_);
    }

  private:
    // Zero where the body lies at rest, or has one edge length everywhere.
    Vec3 center_ = Vec3::Zero();
    Vec3 offset_ = Vec3::Zero();
    Eigen::Matrix3d change_ = Eigen::Matrix3d::Zero();
};

}  // namespace kerf::cut

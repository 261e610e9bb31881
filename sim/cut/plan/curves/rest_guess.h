#pragma once

#include <Eigen/Core>

#include "sim/cut/plan/curves/cut_curves.h"
#include "sim/cut/plan/input/step.h"
#include "sim/cut/plan/strip/strip.h"

namespace kerf::cut {

/// A rough estimate of the rest positions of places of the strip inside the body, for looking up
/// edge lengths: the best affine fit to the curves and the old front. New wall vertices get their
/// rest positions by mapFromSkin.
class RestGuess {
  public:
    /// Fits the map.
    RestGuess(const StepInput& in, const Strip& strip, const CutCurves& curves);
    /// The estimated rest position of a place [m].
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

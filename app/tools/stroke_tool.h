#pragma once

#include "sim/base/math.h"

namespace kerf::app {

/// Keeps a drag on a straight line through its start, in a direction of whole steps of 15 degrees.
/// The direction is fixed once the pointer is far enough away.
class Ruler {
  public:
    static constexpr double kTell = 20;  ///< [px]

    explicit Ruler(const Vec2& start) : start_(start) {}
    /// The point on the line nearest to `pixel`; none while its direction is unknown.
    std::optional<Vec2> along(const Vec2& pixel);

  private:
    Vec2 start_;
    std::optional<Vec2> direction_;  ///< unit
};

}  // namespace kerf::app

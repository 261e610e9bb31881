#pragma once

#include <memory>
#include <optional>

#include "sim/contact/blade_body.h"
#include "sim/contact/obstacles.h"

namespace kerf {

/// The body of the blade as an obstacle: as a static box, but that the blade moves, tapers towards
/// its edge, and stands in the slit that the edge has cut, whose walls it holds apart.
class BladeObstacle final : public Obstacles {
  public:
    static ObstacleKind kind();
    /// Null where the blade does not push.
    static std::unique_ptr<const Obstacles> of(std::optional<BladeMotion> motion);

    /// How the blade moves in the coming step, with a frame more than substeps.
    explicit BladeObstacle(BladeMotion motion) : motion_(std::move(motion)) {}
    std::size_t write(const Bounds& bounds, gpu::Buffer& records) const override;
    TouchDistances distances(const ContactSettings& settings, double edgeLength) const override;

  private:
    BladeMotion motion_;
};

}  // namespace kerf

#pragma once

#include <memory>
#include <vector>

#include "sim/contact/obstacles.h"
#include "sim/contact/static_box.h"

namespace kerf {

/// Static boxes as obstacles; a surface keeps a thickness away from them.
class BoxObstacles final : public Obstacles {
  public:
    static ObstacleKind kind();
    /// Null where there are no boxes.
    static std::unique_ptr<const Obstacles> of(std::vector<StaticBox> boxes);

    explicit BoxObstacles(std::vector<StaticBox> boxes) : boxes_(std::move(boxes)) {}
    std::size_t write(const Bounds& bounds, gpu::Buffer& records) const override;
    bool mayPierce(const Bounds& bounds, double edgeLength) const override;
    TouchDistances distances(const ContactSettings& settings, double edgeLength) const override;

  private:
    std::vector<StaticBox> boxes_;
};

}  // namespace kerf

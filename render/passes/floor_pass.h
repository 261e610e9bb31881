#pragma once

#include <optional>

#include "gpu/program.h"
#include "render/passes/frame.h"

namespace kerf::render {

/// The backdrop, and the grid floor that fades into it.
class FloorPass {
  public:
    FloorPass();
    /// Draws the floor, if there is one at a height, with its shade bound, and the backdrop where
    /// nothing else was drawn.
    void draw(std::optional<double> height, const Frame& frame, const Camera& camera) const;

  private:
    void drawBackdrop(bool hasFloor, const Frame& frame) const;
    void drawFloor(double height, const Frame& frame, const Camera& camera) const;

    gpu::Program backdrop_;
    gpu::Program floor_;
};

}  // namespace kerf::render

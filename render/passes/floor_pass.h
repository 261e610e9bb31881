#pragma once

#include "gpu/program.h"
#include "render/passes/frame.h"

namespace kerf::render {

/// The backdrop, and the grid floor that fades into it.
class FloorPass {
  public:
    FloorPass();
    /// Draws the backdrop where nothing was drawn yet.
    void drawBackdrop(bool hasFloor, const Frame& frame) const;
    /// Blends the floor over the backdrop, with its shade bound.
    void drawFloor(double height, const Frame& frame, const Camera& camera) const;

  private:
    gpu::Program backdrop_;
    gpu::Program floor_;
};

/// Side of a small grid cell for a body of this size: 1 or 2 times a power of ten, about a twelfth
/// [m].
double gridCell(double bodySize);

}  // namespace kerf::render

#pragma once

#include "gpu/buffer.h"
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

/// The boxes that the body collides with: matt, shaded flat, with light edges.
class BoxPass {
  public:
    explicit BoxPass(const gpu::Defines& defines);
    /// Takes the boxes of the scene; before the shadows are drawn.
    void update(const SceneView& scene);
    /// Draws the boxes, with the shadow map bound.
    void draw(const Frame& frame) const;
    /// The boxes as the shadow passes draw them: positions and triangles alone.
    BodyView view() const;

  private:
    gpu::Program program_;
    gpu::Buffer positions_;
    gpu::Buffer triangles_;
    std::uint32_t triangleCount_ = 0;
};

}  // namespace kerf::render

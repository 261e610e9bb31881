#pragma once

#include "gpu/framebuffer.h"
#include "gpu/program.h"
#include "render/passes/frame.h"

namespace kerf::render {

/// Depth of body and boxes seen from the key light.
class ShadowPass {
  public:
    explicit ShadowPass(int size);
    /// `others`: what casts shadows besides the body.
    void draw(const SceneView& scene, const BodyView& others, const Frame& frame);
    /// Binds the map for light.glsl.
    void bind() const;
    int size() const { return map_.width(); }

  private:
    gpu::Program program_;
    gpu::Framebuffer map_;
};

/// The shade of the body on the floor: from the sky where it is close above, and from the key
/// light. Heights above the floor, seen from below and along the light, then blurred.
class FloorShadePass {
  public:
    explicit FloorShadePass(int size);
    void draw(const SceneView& scene, const BodyView& others, const Frame& frame);
    /// Binds the result for floor.frag.
    void bind() const;

  private:
    void blur(const gpu::Framebuffer& from, const gpu::Framebuffer& to,
              const Eigen::Vector2f& stride);

    gpu::Program depthProgram_;
    gpu::Program shadeProgram_;
    gpu::Program blurProgram_;
    gpu::Framebuffer fromBelow_;
    gpu::Framebuffer alongKey_;
    gpu::Framebuffer shade_;
    gpu::Framebuffer scratch_;
};

}  // namespace kerf::render

#pragma once

#include "gpu/framebuffer.h"
#include "gpu/program.h"
#include "render/passes/frame.h"

namespace kerf::render {

/// Depth of the body seen from the key light.
class ShadowPass {
  public:
    explicit ShadowPass(int size);
    void draw(const SceneView& scene, const Frame& frame);
    /// Binds the map for light.glsl.
    void bind() const;
    int size() const { return map_.width(); }

  private:
    gpu::Program program_;
    gpu::Framebuffer map_;
};

/// How much of the sky the body hides from each point of the floor: the body's height above the
/// floor, seen from below, turned into darkness and blurred.
class ContactPass {
  public:
    explicit ContactPass(int size);
    void draw(const SceneView& scene, const Frame& frame);
    /// Binds the result for floor.frag.
    void bind() const;

  private:
    void blur(const gpu::Framebuffer& from, const gpu::Framebuffer& to,
              const Eigen::Vector2f& stride);

    gpu::Program depthProgram_;
    gpu::Program heightProgram_;
    gpu::Program blurProgram_;
    gpu::Framebuffer heights_;
    gpu::Framebuffer shade_;
    gpu::Framebuffer scratch_;
};

}  // namespace kerf::render

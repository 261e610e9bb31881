#pragma once

#include "gpu/framebuffer.h"
#include "gpu/program.h"
#include "render/passes/frame.h"
#include "render/passes/normals_pass.h"
#include "render/scene/scene.h"

namespace kerf::render {

/// A dark line along the rim of each cut, so that closed ones are visible.
class RimPass {
  public:
    RimPass();
    /// Draws over the surface in the bound target.
    void draw(const SceneView& scene, const Frame& frame, const NormalsPass& shape);
    /// Links every program that it may need. Throws gpu::ShaderError.
    void linkEvery() { openedOne(); }

  private:
    const gpu::Program& openedOne();

    gpu::Program whole_;
    std::optional<gpu::Program> opened_;  // from the first picture of a section
};

/// Smooths the edges of body and blade in a frame drawn without multisampling. The floor's lines
/// are smooth already, so only the rectangle around the rest is processed.
class SmoothPass {
  public:
    SmoothPass();
    /// Copies `from` into `to`, of the same size, smoothing the area of the scene's objects.
    void draw(const SceneView& scene, const Frame& frame, const gpu::Framebuffer& from,
              const gpu::Framebuffer& to) const;

  private:
    gpu::Program program_;
};

/// Ambient occlusion: darkens surfaces close to others, such as inside a slit.
class OcclusionPass {
  public:
    OcclusionPass();
    /// Darkens the frame in `drawn`; `plain` has its size and one sample per pixel, and loses its
    /// depth. Leaves `drawn` bound.
    void draw(const Frame& frame, const gpu::Framebuffer& drawn, const gpu::Framebuffer& plain);

  private:
    gpu::Program measure_;
    gpu::Program blur_;
    gpu::Framebuffer open_;
};

}  // namespace kerf::render

#pragma once

#include "gpu/framebuffer.h"
#include "gpu/program.h"
#include "render/passes/frame.h"

namespace kerf::render {

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

}  // namespace kerf::render

#pragma once

#include "gpu/framebuffer.h"
#include "gpu/program.h"
#include "render/passes/frame.h"

namespace kerf::render {

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

#pragma once

#include "gpu/framebuffer.h"
#include "gpu/program.h"
#include "render/passes/frame.h"

namespace kerf::render {

/// Ambient occlusion: darkens what has other things close by, such as the depth of a slit.
class OcclusionPass {
  public:
    OcclusionPass();
    /// Darkens the picture in `drawn`, of which `plain` has the size and one sample per pixel; the
    /// depth in `plain` is lost. Leaves `drawn` bound.
    void draw(const Frame& frame, const gpu::Framebuffer& drawn, const gpu::Framebuffer& plain);

  private:
    gpu::Program measure_;
    gpu::Program blur_;
    gpu::Framebuffer open_;
};

}  // namespace kerf::render

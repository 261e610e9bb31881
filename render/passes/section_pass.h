#pragma once

#include "gpu/program.h"
#include "render/passes/frame.h"
#include "render/passes/surface_pass.h"
#include "render/scene/camera.h"

namespace kerf::render {

/// Fills the body where a section plane opens it. The stencil counts, at each pixel, the surface
/// behind the plane: one more exit than entries means that the plane is inside the body there.
/// Exact, since pieces are closed. The target must have a stencil of zeros.
class SectionPass {
  public:
    SectionPass();
    /// Draws into the bound target, after the body; `surface` has its look.
    void draw(const SceneView& scene, const Frame& frame, const Camera& camera,
              const SurfacePass& surface);
    /// Links every program that it may need. Throws gpu::ShaderError.
    void linkEvery();

  private:
    void count(const SceneView& scene, const Frame& frame) const;
    void fill(const SceneView& scene, const Frame& frame, const SurfacePass& surface);
    const gpu::Program& fillingOf(FleshPattern pattern);

    gpu::Program count_;
    std::map<FleshPattern, gpu::Program> flesh_;
    gpu::Program plain_;
};

}  // namespace kerf::render

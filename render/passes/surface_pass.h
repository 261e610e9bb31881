#pragma once

#include "gpu/program.h"
#include "render/depth_field.h"
#include "render/passes/frame.h"

namespace kerf::render {

/// The body itself: skin, walls, wireframe.
class SurfacePass {
  public:
    explicit SurfacePass(const gpu::Defines& defines);
    void setRestShape(const SurfaceMesh& uncut);
    /// Into the bound target, with the shadow map bound.
    void draw(const SceneView& scene, const Frame& frame, const gpu::Buffer& normals) const;

  private:
    void setMaterial(const SceneView& scene) const;

    gpu::Program program_;
    DepthTexture depth_;
};

}  // namespace kerf::render

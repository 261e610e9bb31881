#pragma once

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "render/passes/frame.h"
#include "shaders/shared/shared_types.h"

namespace kerf::render {

/// The blade as a steel knife, and the surface that it has swept.
class BladePass {
  public:
    BladePass();
    void drawBlade(const SceneView& scene, const Frame& frame);
    void drawSweep(const SceneView& scene, const Frame& frame);
    /// The cutting edge, the outline of the stroke and the force on the blade: bright in the open,
    /// faint inside the body.
    void drawEdges(const SceneView& scene, const Frame& frame);

  private:
    void drawThrough(const std::vector<shared::vec4>& segments, float width,
                     const Eigen::Vector4f& tint, const Frame& frame);
    void drawLines(std::size_t segments, float width, const Eigen::Vector4f& tint,
                   const Frame& frame) const;

    gpu::Program steel_;
    gpu::Program sheet_;
    gpu::Program lines_;
    gpu::Buffer vertices_;
    gpu::Buffer poses_;
    gpu::Buffer segments_;
};

}  // namespace kerf::render

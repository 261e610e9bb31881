#pragma once

#include <optional>

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

}  // namespace kerf::render

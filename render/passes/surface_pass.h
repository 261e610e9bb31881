#pragma once

#include <map>
#include <tuple>

#include "gpu/program.h"
#include "render/passes/frame.h"
#include "render/passes/normals_pass.h"
#include "render/scene/depth_field.h"

namespace kerf::render {

/// The body itself: skin, walls, wireframe.
class SurfacePass {
  public:
    /// `defines` of the quality tier go into every program.
    explicit SurfacePass(gpu::Defines defines) : defines_(std::move(defines)) {}
    void setDepth(const DepthField& depth);
    /// Takes over what another pass was told of the rest shape.
    void takeRestShape(SurfacePass& other) { depth_ = std::move(other.depth_); }
    /// Draws into the bound target, with the shadow map and the environment bound. Compiles the
    /// programs of a look when it is first drawn.
    void draw(const SceneView& scene, const Frame& frame, const NormalsPass& shape);

  private:
    /// What a program is made for; the rest are its uniforms.
    struct Kind {
        SurfaceKind surface = SurfaceKind::skin;
        int pattern = 0;
        Shading shading = Shading::lit;
        bool rounded = false;
        auto operator<=>(const Kind&) const = default;
    };
    const gpu::Program& programOf(const Kind& kind);
    void drawKind(const Kind& kind, const SceneView& scene, const Frame& frame, int sidePieces);
    void setLook(const gpu::Program& program, const SceneView& scene) const;

    gpu::Defines defines_;
    std::map<Kind, gpu::Program> programs_;
    DepthTexture depth_;
};

}  // namespace kerf::render

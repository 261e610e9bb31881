#pragma once

#include <array>
#include <memory>
#include <optional>
#include <utility>

#include "gpu/program.h"
#include "render/passes/frame.h"
#include "render/passes/skin_textures.h"
#include "render/scene/depth_field.h"

namespace kerf::render {

/// The body itself: skin, walls, wireframe.
class SurfacePass {
  public:
    /// `defines` of the quality tier go into every program.
    explicit SurfacePass(const gpu::Defines& defines);
    void setDepth(const DepthField& depth);
    /// Takes over what another pass was told of the rest shape.
    void takeRestShape(SurfacePass& other) { depth_ = std::move(other.depth_); }
    /// Draws into the bound target, with the shadow map bound.
    void draw(const SceneView& scene, const Frame& frame, const gpu::Buffer& normals);

  private:
    const gpu::Program& skinProgram(const SceneView& scene);
    void upload(const std::shared_ptr<const SkinPaint>& paint);
    void drawSkin(const SceneView& scene, const Frame& frame);
    void prepare(const gpu::Program& program, const SceneView& scene, const Frame& frame) const;
    void setLook(const gpu::Program& program, const SceneView& scene) const;

    gpu::Defines defines_;
    std::array<gpu::Program, 2> skins_;       // without and with spots
    std::array<gpu::Program, 3> walls_;       // by FleshPattern
    std::optional<gpu::Program> painted_;     ///< from the first model with colours on
    std::shared_ptr<const SkinPaint> paint_;  ///< that was uploaded last
    gpu::Buffer paintRecords_;
    SkinTextures textures_;
    DepthTexture depth_;
};

}  // namespace kerf::render

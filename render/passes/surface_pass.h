#pragma once

#include <array>
#include <optional>
#include <utility>

#include "gpu/program.h"
#include "render/passes/frame.h"
#include "render/scene/depth_field.h"

namespace kerf::render {

/// Binds what surface.vert reads of the body.
void bindBody(const BodyView& body, const gpu::Buffer& normals);
/// Uniforms of the lines along the rims of cuts, of a program that is in use.
void setCutLines(const gpu::Program& program, const SceneView& scene, const Frame& frame);

/// Uniform of section.glsl, of a program that is in use; the scene must have a section.
void setSection(const gpu::Program& program, const SceneView& scene);

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
    /// Colours and inner structure, of a program that is in use.
    void setLook(const gpu::Program& program, const SceneView& scene) const;

  private:
    /// The programs of a picture, whole or opened by a section.
    struct Programs {
        explicit Programs(const gpu::Defines& defines);
        std::array<gpu::Program, 2> skins;  // without and with spots
        std::array<gpu::Program, 3> walls;  // by FleshPattern
    };
    const Programs& programsFor(const SceneView& scene);
    void drawKind(const gpu::Program& program, const SceneView& scene, const Frame& frame) const;

    gpu::Defines defines_;
    Programs whole_;
    std::optional<Programs> opened_;  // from the first picture of a section
    DepthTexture depth_;
};

}  // namespace kerf::render

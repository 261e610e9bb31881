#pragma once

#include <tuple>

#include "gpu/gl_name.h"
#include "gpu/program.h"
#include "render/passes/frame.h"
#include "render/passes/normals_pass.h"
#include "render/scene/appearance.h"
#include "render/scene/depth_field.h"

namespace kerf::render {

/// The images of a model as textures (move only), with mipmaps and, if supported, anisotropic
/// filtering.
class SkinTextures {
  public:
    SkinTextures() = default;
    /// Uploads the images; reduces those that are larger than the driver allows.
    explicit SkinTextures(std::shared_ptr<const Appearance> appearance);

    /// Whether these are the images of that appearance.
    bool areOf(const std::shared_ptr<const Appearance>& appearance) const {
        return appearance == appearance_;
    }
    /// Binds one, which must exist.
    void bind(int image, std::uint32_t unit) const;

  private:
    std::shared_ptr<const Appearance> appearance_;
    std::vector<gpu::TextureName> ids_;  // by image; none for one that can't be shown
};

/// Binds the buffers of a body for the shaders that draw it.
void bindBody(const BodyView& body, const NormalsPass& shape);
/// Sets the plane of the section, which must exist, in the current program.
void setSection(const gpu::Program& program, const SceneView& scene);

/// The body itself: skin, walls, wireframe.
class SurfacePass {
  public:
    /// `defines` of the quality tier go into every program.
    explicit SurfacePass(gpu::Defines defines) : defines_(std::move(defines)) {}
    void setDepth(const DepthField& depth);
    /// Takes over the rest shape of another pass.
    void takeRestShape(SurfacePass& other) { depth_ = std::move(other.depth_); }
    /// Draws into the bound target, with the shadow map and the environment bound. Compiles the
    /// programs of a look, with those of its walls, on first use.
    void draw(const SceneView& scene, const Frame& frame, const NormalsPass& shape);
    /// Links every program that it may need. Throws gpu::ShaderError.
    void linkEvery();
    /// Sets colours and inner structure in the current program.
    void setLook(const gpu::Program& program, const SceneView& scene) const;

  private:
    /// What a program is made for; the rest are its uniforms.
    struct Kind {
        bool wall = false;
        int pattern = 0;  ///< SkinPattern or FleshPattern
        Shading shading = Shading::lit;
        bool rounded = false;
        bool opened = false;   ///< by a section
        bool painted = false;  ///< in the model's own colours
        auto key() const { return std::tuple(wall, pattern, shading, rounded, opened, painted); }
        bool operator<(const Kind& other) const { return key() < other.key(); }
    };
    static Kind kindOf(const SceneView& scene, const NormalsPass& shape, bool wall);
    gpu::Defines definesOf(const Kind& kind) const;
    const gpu::Program& programOf(const Kind& kind);
    void upload(const std::shared_ptr<const SkinPaint>& paint);
    void drawSkin(const SceneView& scene, const Frame& frame, const NormalsPass& shape);
    void drawPainted(const gpu::Program& skin);
    void prepare(const gpu::Program& program, const SceneView& scene, const Frame& frame) const;

    gpu::Defines defines_;
    std::map<Kind, gpu::Program> programs_;
    std::shared_ptr<const SkinPaint> paint_;  ///< that was uploaded last
    gpu::Buffer paintRecords_;
    SkinTextures textures_;
    DepthTexture depth_;
};

}  // namespace kerf::render

#pragma once

#include "gpu/framebuffer.h"
#include "render/scene/camera.h"
#include "render/scene/depth_field.h"
#include "render/scene/image.h"
#include "render/scene/scene.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::render {

/// Draws a scene into an off-screen target: shadow pass, floor, surface, boxes, blade, overlays.
/// The window and a headless run use the same path, so their pictures agree to the pixel.
class Renderer {
  public:
    /// Throws gpu::ShaderError.
    explicit Renderer(Quality quality);
    ~Renderer();

    Quality quality() const;
    /// Changes the tier from the next frame on. Throws gpu::ShaderError.
    void setQuality(Quality quality);

    /// Links every program that this tier may need, which takes seconds, and draws nothing. Throws
    /// gpu::ShaderError.
    void linkEveryProgram();

    /// Measures how deep each point of the uncut rest shape lies below its skin, so that the rind
    /// and the rings on the cut faces follow that shape. Call it when a model was loaded; cuts
    /// don't change it. Without it, or with an empty mesh, depth comes from the ellipsoid in
    /// restBounds.
    void setRestShape(const SurfaceMesh& uncut);
    /// Takes the result of measureSkinDepth() instead of measuring again.
    void setRestDepth(const DepthField& depth);

    /// The range of the colours of the last frame, which showed a quantity.
    FieldRange fieldRange() const;
    /// Value of that quantity at a vertex, over its skin or its walls. None where there is none, or
    /// where the picture was of another revision of the body (waits for the GPU).
    std::optional<float> fieldAt(int bodyRevision, std::uint32_t vertex, bool onWall) const;

    /// Draws into target(), made or remade at this size.
    void draw(const SceneView& scene, const Camera& camera, int width, int height);
    /// The resolved picture, RGBA8; the editor draws its panels into it and blits it to the window.
    const gpu::Framebuffer& target() const;
    /// Reads target() back.
    Image readPicture() const;

  private:
    struct ShadowSource;
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace kerf::render

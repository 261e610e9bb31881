#pragma once

#include "app/editor/view/editor_view.h"
#include "app/editor/view/rest_depths.h"
#include "gpu/framebuffer.h"
#include "gpu/timer.h"
#include "render/renderer.h"

namespace kerf::app {

/// The frame of the editor: the scene, drawn only if changed, and a copy of it under the panels.
class EditorPicture {
  public:
    /// Throws gpu::ShaderError.
    explicit EditorPicture(render::Quality quality) : renderer_(quality) {}

    /// Depths below the skin of the uncut bodies shown so far.
    RestDepths depths;
    /// Shows that body from the next picture on. Throws gpu::OutOfMemory.
    void setBody(const std::shared_ptr<const UncutBody>& body) {
        renderer_.setRestDepth(depths.of(body));
        drawn_.reset();
    }
    /// Draws the scene if it has `changed`, or if the view differs from the last frame. `covered`
    /// areas need not be drawn. `scene` is null if nothing is open. Throws gpu::ShaderError.
    void draw(const BusyScene& scene, const EditorView& view,
              std::vector<render::PixelRect> covered, bool changed);
    /// Draws a model instead of the scene, likewise if it has `changed` or the view differs.
    void drawModel(const render::SceneView& model, const EditorView& view, bool changed);
    /// Draws the scene of the last frame.
    void keep(const EditorView& view);
    /// Whether the last frame shows the body that was set last.
    bool hasBody() const { return drawn_.has_value(); }
    /// The frame, over which the panels are drawn.
    const gpu::Framebuffer& target() const { return target_; }
    /// Adds up what takeSceneMilliseconds() returns, once a picture.
    void measure() { sceneMilliseconds_ += sceneTimer_.takeMilliseconds(); }
    /// Drawing time of the scene in the pictures since the last call [ms].
    double takeSceneMilliseconds() { return std::exchange(sceneMilliseconds_, 0); }

    /// The range of the colours of the last frame, if they show a quantity.
    const render::FieldRange& fieldRange() const { return fieldRange_; }
    /// The present value of that quantity at a point of the surface; none if the frame is older, or
    /// without a value there (waits for the GPU).
    std::optional<double> fieldAt(EditorScene& scene, const SurfacePoint& point) const;

    /// A copy of target() in main memory.
    render::Image read() const { return {target_.width(), target_.height(), target_.readColor()}; }
    /// What the panels leave free of target(), before they are drawn over it.
    render::Image readFree(const EditorView& view) const;
    /// The scene alone, without panels and background.
    render::Image readScene(EditorScene& scene, const EditorView& view);

  private:
    /// All drawing inputs except the scene.
    struct Shot {
        ViewFrame frame;
        BodyDisplay display;
        std::vector<render::PixelRect> covered;
        bool bright = false;
        bool ofScene = true;
        std::optional<Vec3> ledTo{};  ///< where the hand leads the blade
        bool operator==(const Shot&) const = default;
    };
    void fit(const EditorView& view);
    void drawScene(const BusyScene& scene, const Shot& shot, bool transparent);

    render::Renderer renderer_;
    gpu::Timer sceneTimer_;
    double sceneMilliseconds_ = 0;
    gpu::Framebuffer target_;
    render::FieldRange fieldRange_;
    std::optional<Shot> drawn_;  ///< the picture of the scene that the renderer holds
};

}  // namespace kerf::app

#pragma once

#include <optional>
#include <vector>

#include "app/editor/steps/rest_depths.h"
#include "app/editor/view/editor_view.h"
#include "gpu/framebuffer.h"
#include "gpu/timer.h"
#include "render/renderer.h"
#include "sim/base/stopwatch.h"

namespace kerf::app {

/// The picture of the editor: the scene, drawn only where it has changed, and room for the panels
/// over a copy of it.
class EditorPicture {
  public:
    /// Throws gpu::ShaderError.
    explicit EditorPicture(render::Quality quality) : renderer_(quality) {}

    /// The depth of each point below the skin of uncut bodies, as far as they were met.
    RestDepths depths;
    /// Shows that body from the next picture on. Throws gpu::OutOfMemory.
    void setBody(const std::shared_ptr<const UncutBody>& body) {
        renderer_.setRestDepth(depths.of(body));
    }
    /// Draws the scene where it has `changed`, or is seen otherwise than in the last picture. What
    /// lies in `covered` need not be drawn. `scene` is null while nothing is open. Throws
    /// gpu::ShaderError.
    void draw(const BusyScene& scene, const EditorView& view,
              std::vector<render::PixelRect> covered, bool changed);
    /// Draws something else than the scene, as the others where it has `changed` or is seen
    /// otherwise.
    void drawModel(const render::SceneView& model, const EditorView& view, bool changed);
    /// Draws the scene as it was in the last picture.
    void keep(const EditorView& view);
    /// Whether steps had better go on for a while before they are shown: where a picture of the
    /// scene takes long, most of the time is theirs.
    bool rests() const;
    /// The picture, over which the panels go.
    const gpu::Framebuffer& target() const { return target_; }
    /// Reads what sceneMilliseconds() tells, once a picture.
    void measure() { sceneMilliseconds_ = sceneTimer_.takeMilliseconds(); }
    /// Time that the scene of the last picture took to draw [ms].
    double sceneMilliseconds() const { return sceneMilliseconds_; }

    /// What the colours of the last picture reach from and to, where they show a quantity.
    const render::FieldRange& fieldRange() const { return fieldRange_; }
    /// The value of that quantity at a point of the surface as it is; none where the picture is
    /// older, or the quantity has none there (waits for the GPU).
    std::optional<double> fieldAt(EditorScene& scene, const SurfacePoint& point) const;

    /// A copy of target() in main memory.
    render::Image read() const { return {target_.width(), target_.height(), target_.readColor()}; }
    /// What the panels leave free of target(), before they are drawn over it.
    render::Image readFree(const EditorView& view) const;
    /// The scene alone, without panels and background.
    render::Image readScene(EditorScene& scene, const EditorView& view);

  private:
    /// All that a scene is drawn with, apart from itself.
    struct Shot {
        ViewFrame frame;
        BodyDisplay display;
        std::vector<render::PixelRect> covered;
        bool bright = false;
        bool ofScene = true;
        bool operator==(const Shot&) const = default;
    };
    void fit(const EditorView& view);
    void drawScene(const BusyScene& scene, const Shot& shot, bool transparent);

    render::Renderer renderer_;
    gpu::Timer sceneTimer_;
    double sceneMilliseconds_ = 0;
    gpu::Framebuffer target_;
    render::FieldRange fieldRange_;
    double drawSeconds_ = 0;  ///< that the last picture of the scene took
    Stopwatch sinceDrawn_;
    std::optional<Shot> drawn_;  ///< the picture of the scene that the renderer holds
};

}  // namespace kerf::app

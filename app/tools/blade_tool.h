#pragma once

#include <optional>

#include "app/scene/editor_scene.h"
#include "app/tools/guillotine.h"
#include "app/tools/ruler.h"
#include "app/tools/scalpel.h"
#include "app/tools/view_frame.h"
#include "ui/overlay.h"
#include "ui/tool_settings.h"

namespace kerf::app {

/// Leads the blade by the pointer, in one of three ways, and shows what it will cut. It answers
/// with poses in the scene's stroke.
class BladeTool {
  public:
    /// Fits depths, radii and the guillotine's pose to another body.
    void fitTo(const Bounds& bounds);

    const ui::ToolSettings& settings() const { return settings_; }
    /// Takes another tool, while none of them holds anything.
    void choose(ui::Tool tool) { settings_.tool = tool; }
    /// Takes another tool or another depth; a guillotine that is lowered cuts.
    void set(const ui::ToolSettings& settings, EditorScene& scene);

    /// Takes the blade or a handle at a pixel of the picture.
    void press(const ViewFrame& view, const Vec2& pixel, EditorScene& scene);
    /// Leads the blade to a pixel of the picture. A `straight` stroke goes on along a line (see
    /// Ruler).
    void move(const ViewFrame& view, const Vec2& pixel, bool straight, EditorScene& scene);
    /// Ends the stroke, or lets go of the handle.
    void release(EditorScene& scene);
    /// Gives up the stroke and lets go of everything.
    void cancel(EditorScene& scene);
    /// Whether the tool holds the blade or a handle.
    bool holds() const { return held_ || handle_.has_value(); }

    /// The guillotine falls from where it is.
    void bringDown(EditorScene& scene);

    /// A preview of the coming cut.
    ui::Overlay overlay(const ViewFrame& view, const Vec2& pixel, EditorScene& scene) const;

    /// The part of it that is known without a look at the body: the way of the stroke.
    static ui::Overlay swept(const ViewFrame& view, const BladeStroke& stroke);

  private:
    void pressStroke(const ViewFrame& view, const Vec2& pixel, EditorScene& scene);
    void moveScalpel(const ViewFrame& view, const Vec2& pixel, EditorScene& scene);
    void lowerTo(double lowered, EditorScene& scene);
    void raise(EditorScene& scene);
    std::optional<Guillotine::Handle> handleAt(const ViewFrame& view, const Vec2& pixel) const;
    std::vector<Blade> wayAhead(const ViewFrame& view, const Vec2& pixel, EditorScene& scene) const;
    void addHandles(const ViewFrame& view, const Vec2& pixel, ui::Overlay& overlay) const;

    ui::ToolSettings settings_;
    Guillotine guillotine_;
    std::optional<Scalpel> scalpel_;  ///< while it is on the surface
    std::optional<Guillotine::Handle> handle_;
    bool held_ = false;  ///< by the pointer
    std::optional<Ruler> ruler_;
};

}  // namespace kerf::app

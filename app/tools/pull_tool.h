#pragma once

#include <optional>
#include <string>

#include "app/scene/editor_scene.h"
#include "app/tools/view_frame.h"
#include "ui/input.h"
#include "ui/overlay.h"
#include "ui/tool_settings.h"

namespace kerf::app {

/// Touches the body by the pointer: pulls at it (Tool::grab), or pins parts of it and frees them
/// again (Tool::pin), with a brush or a box.
class PullTool {
  public:
    /// Takes hold of the body, or begins a brush or a box, at a pixel of the picture, where one of
    /// its tools is chosen. Returns "" or one sentence.
    std::string press(const ViewFrame& view, const Vec2& pixel, const ui::ToolSettings& settings,
                      const ui::Modifiers& modifiers, EditorScene& scene);
    void move(const ViewFrame& view, const Vec2& pixel, EditorScene& scene);
    /// Lets go, and pins or frees what is in the box. Returns "" or one sentence.
    std::string release(const ViewFrame& view, EditorScene& scene);
    /// Lets go, and forgets a box that is being drawn.
    void cancel(EditorScene& scene);
    bool holds() const { return held_ || brush_ || box_; }

    /// Adds the part of the body that the tool would take hold of, or holds.
    void addTo(ui::Overlay& overlay, const ViewFrame& view, const Vec2& pixel,
               const ui::ToolSettings& settings, EditorScene& scene) const;

  private:
    struct Brush {
        double radius = 0;  ///< [m]
        bool pins = true;   ///< false: frees
        bool begun = false;
        Vec2 last = Vec2::Zero();  ///< [px]
    };
    struct Box {
        bool pins = true;
        Vec2 from = Vec2::Zero();  ///< [px]
        Vec2 to = Vec2::Zero();
    };
    void paint(const ViewFrame& view, const Vec2& pixel, EditorScene& scene);
    void paintUpTo(const ViewFrame& view, const Vec2& pixel, EditorScene& scene);

    std::optional<Vec3> held_;  ///< where it took hold [m]
    Vec3 to_ = Vec3::Zero();    ///< where it has pulled that [m]
    std::optional<Brush> brush_;
    std::optional<Box> box_;
};

/// The box between two points of the view: across the axis nearest to the line of sight it lies in
/// the plane through the middle of `body`, along that it reaches through all of `body`.
Bounds boxBetween(const ViewFrame& view, const Vec2& from, const Vec2& to, const Bounds& body);

}  // namespace kerf::app

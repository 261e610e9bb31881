#pragma once

#include <array>
#include <optional>
#include <string>

#include "app/scene/editor_scene.h"
#include "app/tools/view_frame.h"
#include "ui/overlay.h"

namespace kerf::app {

/// Holds cuts open (Tool::retract): a press beside a cut hooks both lips, a drag pulls them apart
/// by the way of the pointer, and they stay so. A drag of a hook moves its retractor on.
class RetractTool {
  public:
    /// Hooks the lips near a pixel of the picture, or takes a hook there. Returns "" or one
    /// sentence.
    std::string press(const ViewFrame& view, const Vec2& pixel, EditorScene& scene);
    void move(const ViewFrame& view, const Vec2& pixel, EditorScene& scene);
    /// Leaves the hooks where they are.
    void release(EditorScene& scene);
    /// Brings a retractor back to where it was, or takes away a new one.
    void cancel(EditorScene& scene);
    bool holds() const { return drag_.has_value(); }

    /// The hook at a pixel.
    static std::optional<int> hookAt(const ViewFrame& view, const Vec2& pixel,
                                     const EditorScene& scene);
    /// Adds the hooks, and the lips that a press would hook.
    void addTo(ui::Overlay& overlay, const ViewFrame& view, const Vec2& pixel,
               EditorScene& scene) const;

  private:
    /// A retractor that is being drawn apart.
    struct Opening {
        std::array<int, 2> hooks{};
        std::array<Vec3, 2> from;     ///< where they were [m]
        Vec3 across = Vec3::UnitX();  ///< unit, from the first to the second
        Vec3 at = Vec3::Zero();       ///< where the pointer took hold [m]
        bool isNew = true;
        double before = 0;  ///< how far they stood apart [m]
        double by = 0;      ///< how much farther they shall stand [m]
    };
    void moveHooks(EditorScene& scene) const;
    std::string hookLips(const ViewFrame& view, const Vec2& pixel, EditorScene& scene);
    void takeAgain(int hook, const EditorScene& scene);
    void addLips(ui::Overlay& overlay, const ViewFrame& view, const Vec2& pixel,
                 EditorScene& scene) const;

    std::optional<Opening> drag_;
};

}  // namespace kerf::app

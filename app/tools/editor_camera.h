#pragma once

#include "render/scene/camera.h"
#include "ui/input.h"

namespace kerf::app {

/// Turns, moves and zooms a camera with the pointer: right or Alt+left drag orbits, middle or
/// Shift+right drag pans, the wheel zooms to the pointer.
class CameraControl {
  public:
    /// Whether a press of this button belongs to the camera; if so, the drag begins.
    bool press(const ui::ButtonChange& change);
    void release(ui::Button button);
    void releaseAll() { motion_ = Motion::none; }
    /// Follows a pointer that moved by (dx, dy) pixels in a view `height` pixels high. True where
    /// the camera moved.
    bool move(render::Camera& camera, double dx, double dy, double height) const;
    bool dragging() const { return motion_ != Motion::none; }

    /// Zooms to the pointer `ndc` (-1..1, y up); in with `notches` > 0.
    static void zoom(render::Camera& camera, double notches, const Vec2& ndc, double aspect);

  private:
    enum class Motion { none, orbit, pan };
    Motion motion_ = Motion::none;
    ui::Button button_ = ui::Button::right;
};

/// Brings a camera back that went too far from a body or too near to its target: beyond, numbers
/// lose their digits and pictures are empty.
void keepNear(render::Camera& camera, const Bounds& body);

/// Views along the axes, as numbered in modelling programs.
enum class AxisView { front, back, right, left, top, bottom };
/// Looks at the camera's target along an axis, from where it stands away.
void lookAlong(render::Camera& camera, AxisView view);

}  // namespace kerf::app

#pragma once

#include "render/scene/camera.h"
#include "ui/base/input.h"
#include "ui/base/settings.h"

namespace kerf::app {

/// Views along the axes, as numbered in modelling programs.
enum class AxisView { front, back, right, left, top, bottom };
/// Looks at the camera's target along an axis, from the same distance.
void lookAlong(render::Camera& camera, AxisView view);
/// Limits the distance of a camera from a body and its target: beyond, floats lose their digits and
/// frames are empty.
void keepNear(render::Camera& camera, const Bounds& body);

/// The camera of the editor's view. Drags orbit, pan and zoom by a MouseScheme, the wheel zooms to
/// the pointer. It moves smoothly to other views; actions meanwhile apply to the final view.
class EditorCamera {
  public:
    static constexpr double kFlightSeconds = 0.22;

    EditorCamera() = default;
    explicit EditorCamera(const render::Camera& shown) : shown_(shown) {}

    const render::Camera& shown() const { return shown_; }
    /// The view at the end of a flight; otherwise the current one.
    const render::Camera& destination() const { return flight_ ? flight_->to : shown_; }
    bool flying() const { return flight_.has_value(); }
    /// Advances a flight by so much time.
    void advance(double seconds);
    void flyTo(const render::Camera& camera) { flight_ = Flight{shown_, camera}; }
    /// Flies to where `bounds` [m] fill so much of the view's height.
    void flyToFrame(const Bounds& bounds, double share = 1);
    /// Flies to a view along an axis.
    void flyTo(AxisView view);
    void toggleOrthographic();

    /// Ends a flight. Returns whether the press begins a drag of the camera.
    bool press(const ui::ButtonChange& change, ui::MouseScheme scheme = ui::MouseScheme::kerf);
    void release(ui::Button button);
    void releaseAll() { motion_ = ui::ViewMotion::none; }
    bool dragging() const { return motion_ != ui::ViewMotion::none; }
    /// Follows a pointer that moved by `by` [pixels] in a view `height` pixels high. Returns
    /// whether the camera moved.
    bool drag(const Vec2& by, double height);
    /// Zooms to the pointer `ndc` (-1..1, y up); in with `notches` > 0.
    void zoom(double notches, const Vec2& ndc, double aspect);
    /// Like the function of this name.
    void keepNear(const Bounds& body) { app::keepNear(shown_, body); }

  private:
    void land();

    struct Flight {
        render::Camera from;
        render::Camera to;
        double flown = 0;  ///< [s]
    };

    render::Camera shown_;
    std::optional<Flight> flight_;
    ui::ViewMotion motion_ = ui::ViewMotion::none;
    ui::Button button_ = ui::Button::right;  ///< that drags
};

}  // namespace kerf::app

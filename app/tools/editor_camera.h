#pragma once

#include <optional>

#include "render/scene/camera.h"
#include "ui/base/input.h"
#include "ui/base/mouse_scheme.h"

namespace kerf::app {

/// Views along the axes, as numbered in modelling programs.
enum class AxisView { front, back, right, left, top, bottom };
/// Looks at the camera's target along an axis, from where it stands away.
void lookAlong(render::Camera& camera, AxisView view);
/// Brings a camera back that went too far from a body or too near to its target: beyond, numbers
/// lose their digits and pictures are empty.
void keepNear(render::Camera& camera, const Bounds& body);

/// The camera of the editor's view. Drags orbit, pan and zoom as a MouseScheme tells, the wheel
/// zooms to the pointer. To other views it flies within a moment, so that the eye can follow;
/// whatever is done meanwhile is done in the view at the end.
class EditorCamera {
  public:
    static constexpr double kFlightSeconds = 0.22;

    EditorCamera() = default;
    explicit EditorCamera(const render::Camera& shown) : shown_(shown) {}

    const render::Camera& shown() const { return shown_; }
    /// The view at the end of a flight; what is shown while there is none.
    const render::Camera& destination() const { return flight_ ? flight_->to : shown_; }
    bool flying() const { return flight_.has_value(); }
    /// Goes on with a flight by so much time.
    void advance(double seconds);
    void flyTo(const render::Camera& camera) { flight_ = Flight{shown_, camera}; }
    /// Flies to where `bounds` [m] fill so much of the view's height.
    void flyToFrame(const Bounds& bounds, double share = 1);
    /// Flies to a view along an axis.
    void flyTo(AxisView view);
    void toggleOrthographic();

    /// Ends a flight. Whether the press belongs to the camera; if so, a drag is under way.
    bool press(const ui::ButtonChange& change, ui::MouseScheme scheme = ui::MouseScheme::kerf);
    void release(ui::Button button);
    void releaseAll() { motion_ = ui::ViewMotion::none; }
    bool dragging() const { return motion_ != ui::ViewMotion::none; }
    /// Follows a pointer that moved by so many pixels in a view `height` pixels high. True where
    /// the camera moved.
    bool drag(const Vec2& by, double height);
    /// Zooms to the pointer `ndc` (-1..1, y up); in with `notches` > 0.
    void zoom(double notches, const Vec2& ndc, double aspect);
    /// As the function of this name.
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

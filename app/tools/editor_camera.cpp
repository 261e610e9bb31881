#include "app/tools/editor_camera.h"

namespace kerf::app {
namespace {

constexpr double kRadiansPerHeight = 3.5;  // a drag over the whole height turns by 200 degrees
constexpr double kZoomPerNotch = 0.88;
constexpr double kNotchesPerHeight = 20;  // of a drag over all of the view
constexpr double kMostNotches = 20;       // of one event: eye and target must stay apart
constexpr double kNearestTarget = 1e-3;   // of the body's diagonal
constexpr double kFarthest = 100;  // of the body's diagonal: eye from target, target from body
constexpr double kOffPole = 1e-4;  // from above: "up" still says which way the view is turned [rad]

/// The unit direction from the target to the eye.
Vec3 directionOf(AxisView view) {
    switch (view) {
        case AxisView::front:
            return Vec3::UnitZ();
        case AxisView::back:
            return -Vec3::UnitZ();
        case AxisView::right:
            return Vec3::UnitX();
        case AxisView::left:
            return -Vec3::UnitX();
        case AxisView::top:
            return Vec3(0, 1, kOffPole).normalized();
        case AxisView::bottom:
            return Vec3(0, -1, kOffPole).normalized();
    }
    return Vec3::UnitZ();
}

}  // namespace

void keepNear(render::Camera& camera, const Bounds& body) {
    const double size = body.diagonal();
    if (size <= 0) {
        return;
    }
    const Vec3 arm = camera.eye - camera.target;
    const double distance = std::clamp(arm.norm(), kNearestTarget * size, kFarthest * size);
    const Vec3 aside = camera.target - body.center();
    if (aside.norm() > kFarthest * size) {
        camera.target = body.center() + kFarthest * size * aside.normalized();
    }
    camera.eye = camera.target + distance * arm.normalized();
}

void lookAlong(render::Camera& camera, AxisView view) {
    const double distance = (camera.eye - camera.target).norm();
    camera.up = Vec3::UnitY();
    camera.eye = camera.target + distance * directionOf(view);
}

// --- Flights -----------------------------------------------------------------------------------

void EditorCamera::advance(double seconds) {
    if (!flight_) {
        return;
    }
    flight_->flown += seconds;
    if (flight_->flown >= kFlightSeconds) {
        land();
    } else {
        shown_ = render::between(flight_->from, flight_->to,
                                 render::eased(flight_->flown / kFlightSeconds));
    }
}

void EditorCamera::land() {
    shown_ = destination();
    flight_.reset();
}

void EditorCamera::flyToFrame(const Bounds& bounds, double share) {
    render::Camera wanted = destination();
    wanted.frame(bounds, share);
    flyTo(wanted);
}

void EditorCamera::flyTo(AxisView view) {
    render::Camera wanted = destination();
    lookAlong(wanted, view);
    flyTo(wanted);
}

void EditorCamera::toggleOrthographic() {
    land();
    shown_.orthographic = !shown_.orthographic;
}

// --- The pointer -------------------------------------------------------------------------------

bool EditorCamera::press(const ui::ButtonChange& change, ui::MouseScheme scheme) {
    land();
    if (dragging()) {
        return true;
    }
    motion_ = ui::motionOf(scheme, change.button, change.modifiers);
    button_ = change.button;
    return dragging();
}

void EditorCamera::release(ui::Button button) {
    if (button == button_) {
        motion_ = ui::ViewMotion::none;
    }
}

bool EditorCamera::drag(const Vec2& by, double height) {
    if (motion_ == ui::ViewMotion::orbit) {
        shown_.orbit(-kRadiansPerHeight * by.x() / height, kRadiansPerHeight * by.y() / height);
    } else if (motion_ == ui::ViewMotion::pan) {
        shown_.pan(-by.x() / height, by.y() / height);
    } else if (motion_ == ui::ViewMotion::zoom) {
        shown_.zoom(std::pow(kZoomPerNotch, -kNotchesPerHeight * by.y() / height), {0, 0}, 1);
    }
    return dragging();
}

void EditorCamera::zoom(double notches, const Vec2& ndc, double aspect) {
    land();
    notches = std::clamp(notches, -kMostNotches, kMostNotches);
    shown_.zoom(std::pow(kZoomPerNotch, notches), ndc, aspect);
}

}  // namespace kerf::app

#include "app/tools/editor_camera.h"

#include <algorithm>
#include <cmath>

namespace kerf::app {
namespace {

constexpr double kRadiansPerHeight = 3.5;  // a drag over the whole height turns by 200 degrees
constexpr double kZoomPerNotch = 0.88;
constexpr double kMostNotches = 20;      // of one event: eye and target must stay apart
constexpr double kNearestTarget = 1e-3;  // of the body's diagonal
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

bool CameraControl::press(const ui::ButtonChange& change) {
    if (dragging()) {
        return true;
    }
    const bool orbits = (change.button == ui::Button::right && !change.modifiers.shift) ||
                        (change.button == ui::Button::left && change.modifiers.alt);
    const bool pans = change.button == ui::Button::middle ||
                      (change.button == ui::Button::right && change.modifiers.shift);
    if (!orbits && !pans) {
        return false;
    }
    motion_ = pans ? Motion::pan : Motion::orbit;
    button_ = change.button;
    return true;
}

void CameraControl::release(ui::Button button) {
    if (button == button_) {
        motion_ = Motion::none;
    }
}

bool CameraControl::move(render::Camera& camera, double dx, double dy, double height) const {
    switch (motion_) {
        case Motion::none:
            return false;
        case Motion::orbit:
            camera.orbit(-kRadiansPerHeight * dx / height, kRadiansPerHeight * dy / height);
            return true;
        case Motion::pan:
            camera.pan(-dx / height, dy / height);
            return true;
    }
    return false;
}

void CameraControl::zoom(render::Camera& camera, double notches, const Vec2& ndc, double aspect) {
    notches = std::clamp(notches, -kMostNotches, kMostNotches);
    camera.zoom(std::pow(kZoomPerNotch, notches), ndc, aspect);
}

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

}  // namespace kerf::app

#include "render/scene/camera.h"

namespace kerf::render {

namespace {

constexpr double kNearShare = 0.02;        // of the distance to the target
constexpr double kFarShare = 80.0;         // of the distance to the target
constexpr double kOrthographicReach = 25;  // of the distance, to both sides of the target
constexpr double kPoleMargin = 0.03;       // closest approach to the poles [rad]

struct ViewAxes {
    Vec3 forward;
    Vec3 right;
    Vec3 up;
};

Vec3 anyPerpendicular(const Vec3& forward) {
    // Seen straight from above, -z points up on the screen, as on a map.
    const Vec3 map = forward.cross(Vec3(0, 0, -1));
    return map.norm() > 1e-6 ? map : forward.cross(Vec3(1, 0, 0));
}

ViewAxes frameOf(const Camera& camera) {
    ViewAxes frame;
    const Vec3 toTarget = camera.target - camera.eye;
    frame.forward = toTarget.norm() > 0 ? Vec3(toTarget.normalized()) : Vec3(0, 0, -1);
    Vec3 right = frame.forward.cross(camera.up);
    if (right.norm() < 1e-6 * camera.up.norm()) {
        right = anyPerpendicular(frame.forward);
    }
    frame.right = right.normalized();
    frame.up = frame.right.cross(frame.forward);
    return frame;
}

double distance(const Camera& camera) {
    return (camera.target - camera.eye).norm();
}

double tanHalfFov(const Camera& camera) {
    return std::tan(0.5 * camera.fovY * std::numbers::pi / 180.0);
}

/// Columns: right, up, back.
Eigen::Quaterniond orientationOf(const Camera& camera) {
    const Eigen::Matrix3d turn = camera.view().topLeftCorner<3, 3>().cast<double>().transpose();
    return Eigen::Quaterniond(turn).normalized();
}

double distanceOf(const Camera& camera) {
    return std::max((camera.eye - camera.target).norm(), 1e-9);
}

}  // namespace

Eigen::Matrix4f Camera::view() const {
    const ViewAxes frame = frameOf(*this);
    Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
    m.block<1, 3>(0, 0) = frame.right.transpose();
    m.block<1, 3>(1, 0) = frame.up.transpose();
    m.block<1, 3>(2, 0) = -frame.forward.transpose();
    m(0, 3) = -frame.right.dot(eye);
    m(1, 3) = -frame.up.dot(eye);
    m(2, 3) = frame.forward.dot(eye);
    return m.cast<float>();
}

Eigen::Matrix4f Camera::projection(double aspect) const {
    const double f = 1.0 / (tanHalfFov(*this) * (orthographic ? distance(*this) : 1));
    const double n = nearPlane();
    const double z = farPlane();
    Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
    m(0, 0) = f / aspect;
    m(1, 1) = f;
    if (orthographic) {
        m(2, 2) = 2 / (n - z);
        m(2, 3) = (z + n) / (n - z);
        m(3, 3) = 1;
        m(0, 3) += middle.x();
        m(1, 3) += middle.y();
    } else {
        m(2, 2) = (z + n) / (n - z);
        m(2, 3) = 2 * z * n / (n - z);
        m(3, 2) = -1;
        m(0, 2) -= middle.x();
        m(1, 2) -= middle.y();
    }
    return m.cast<float>();
}

double Camera::nearPlane() const {
    return (orthographic ? 1 - kOrthographicReach : kNearShare) * distance(*this);
}

double Camera::farPlane() const {
    return (orthographic ? 1 + kOrthographicReach : kFarShare) * distance(*this);
}

Vec3 Camera::forward() const {
    return frameOf(*this).forward;
}

Vec3 Camera::towardsEye(const Vec3& point) const {
    return orthographic ? Vec3(-forward()) : Vec3((eye - point).normalized());
}

void Camera::orbit(double yaw, double pitch) {
    const Vec3 axis = up.normalized();
    const Vec3 arm = eye - target;
    const double elevation = std::asin(std::clamp(arm.normalized().dot(axis), -1.0, 1.0));
    const double limit = 0.5 * std::numbers::pi - kPoleMargin;
    const double wanted = std::clamp(elevation + pitch, -limit, limit);
    const Vec3 right = frameOf(*this).right;
    const Vec3 pitched = Eigen::AngleAxisd(elevation - wanted, right) * arm;
    eye = target + Eigen::AngleAxisd(yaw, axis) * pitched;
}

void Camera::pan(double dx, double dy) {
    const ViewAxes frame = frameOf(*this);
    const double height = 2 * tanHalfFov(*this) * distance(*this);
    const Vec3 move = height * (dx * frame.right + dy * frame.up);
    eye += move;
    target += move;
}

void Camera::zoom(double factor, const Vec2& ndc, double aspect) {
    const Vec3 fixed = pointAt(ndc, aspect, distance(*this));
    eye = fixed + factor * (eye - fixed);
    target = fixed + factor * (target - fixed);
}

void Camera::frame(const Bounds& bounds, double share) {
    if (bounds.empty()) {
        return;
    }
    const ViewAxes frame = frameOf(*this);
    const double tangent = share * tanHalfFov(*this);
    const Vec3 center = bounds.center();
    double needed = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 q = bounds.corner(corner) - center;
        const double sideways = std::max(std::abs(q.dot(frame.right)), std::abs(q.dot(frame.up)));
        const double nearer = orthographic ? 0 : -q.dot(frame.forward);
        needed = std::max(needed, sideways / tangent + nearer);
    }
    target = center;
    eye = center - frame.forward * std::max(needed, 1e-9);
}

Ray Camera::ray(const Vec2& ndc, double aspect) const {
    const ViewAxes frame = frameOf(*this);
    const double tangent = tanHalfFov(*this);
    const Vec2 at = ndc - middle;
    const Vec3 aside = frame.right * (at.x() * tangent * aspect) + frame.up * (at.y() * tangent);
    if (orthographic) {
        return {eye + distance(*this) * aside + nearPlane() * frame.forward, frame.forward};
    }
    return {eye, (frame.forward + aside).normalized()};
}

Vec3 Camera::pointAt(const Vec2& ndc, double aspect, double depth) const {
    const Ray through = ray(ndc, aspect);
    const Vec3 ahead = forward();
    const double missing = depth - (through.origin - eye).dot(ahead);
    return through.origin + through.direction * (missing / through.direction.dot(ahead));
}

Camera between(const Camera& from, const Camera& to, double share) {
    const Eigen::Matrix3d turn =
        orientationOf(from).slerp(share, orientationOf(to)).toRotationMatrix();
    const double distance = distanceOf(from) * std::pow(distanceOf(to) / distanceOf(from), share);
    Camera camera = to;
    camera.target = from.target + share * (to.target - from.target);
    camera.eye = camera.target + distance * turn.col(2);
    camera.up = turn.col(1);
    camera.fovY = from.fovY + share * (to.fovY - from.fovY);
    return camera;
}

double eased(double share) {
    return share * share * (3 - 2 * share);
}

CameraPath::CameraPath(std::vector<CameraKey> keys) : keys_(std::move(keys)) {}

Camera CameraPath::at(double moment) const {
    const auto next = std::ranges::upper_bound(keys_, moment, {}, &CameraKey::at);
    if (next == keys_.begin()) {
        return next->camera;
    }
    const CameraKey& last = *std::prev(next);
    if (next == keys_.end()) {
        return last.camera;
    }
    return between(last.camera, next->camera, eased((moment - last.at) / (next->at - last.at)));
}

}  // namespace kerf::render

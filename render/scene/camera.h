#pragma once

#include "sim/base/math.h"

namespace kerf::render {

/// A half-line.
struct Ray {
    Vec3 origin = Vec3::Zero();
    Vec3 direction = Vec3::UnitZ();  ///< unit
};

/// A camera, as the "view" of a session file.
struct Camera {
    Vec3 eye = {3, 2, 4};
    Vec3 target = {0, 0, 0};
    Vec3 up = {0, 1, 0};
    double fovY = 35;  ///< vertical field of view [degrees]
    /// Parallel rays, with the height of the perspective view at the target.
    bool orthographic = false;
    /// The position of the target in the frame (-1..1, y up); not part of a session.
    Vec2 middle = Vec2::Zero();

    /// World to eye space.
    Eigen::Matrix4f view() const;
    /// Depth range chosen from the distance to the target.
    Eigen::Matrix4f projection(double aspect) const;
    /// Along the line of sight from the eye; behind it in an orthographic view [m].
    double nearPlane() const;
    double farPlane() const;  ///< [m]
    /// Unit, from the eye to the target.
    Vec3 forward() const;
    /// Unit, from a point towards the eye.
    Vec3 towardsEye(const Vec3& point) const;

    /// Rotates about the target: yaw about up, pitch about the right axis, clamped short of the
    /// poles [rad].
    void orbit(double yaw, double pitch);
    /// Moves eye and target in the view plane; dx, dy as shares of the view height.
    void pan(double dx, double dy);
    /// Scales the distance to the target by `factor`, keeping the world point under `ndc`
    /// (-1..1, y up) in place.
    void zoom(double factor, const Vec2& ndc, double aspect);
    /// Moves along the view direction until `bounds` fills so much of the view's height.
    void frame(const Bounds& bounds, double share = 1);

    /// World ray through `ndc` (-1..1, y up), from the eye or, orthographic, from the near plane.
    Ray ray(const Vec2& ndc, double aspect) const;
    /// The point where the ray at `ndc` hits the plane across the line of sight, `depth` [m] in
    /// front of the eye.
    Vec3 pointAt(const Vec2& ndc, double aspect, double depth) const;
};

/// The view between two others, `share` 0 to 1: turned the short way, at geometric distances.
Camera between(const Camera& from, const Camera& to, double share);
/// Smooth easing: the share of the path at a share of the time, 0 to 1.
double eased(double share);

/// A camera at a time [steps].
struct CameraKey {
    double at = 0;
    Camera camera;
};

/// The path of a camera through its keys. It rests at each, and does not move before the first and
/// after the last.
class CameraPath {
  public:
    CameraPath() = default;
    /// Keys by time; the last of several at one time counts.
    explicit CameraPath(std::vector<CameraKey> keys);

    /// Whether there are no keys, and so no camera.
    bool empty() const { return keys_.empty(); }
    /// The camera at a time [steps]. Needs a key.
    Camera at(double moment) const;

  private:
    std::vector<CameraKey> keys_;
};

}  // namespace kerf::render

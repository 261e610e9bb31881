#pragma once

#include "sim/math.h"

namespace kerf::render {

/// A perspective camera, as the "view" of a session file.
struct Camera {
    Vec3 eye = {3, 2, 4};
    Vec3 target = {0, 0, 0};
    Vec3 up = {0, 1, 0};
    double fovY = 35;  ///< vertical field of view [degrees]

    /// World to eye space.
    Eigen::Matrix4f view() const;
    /// Depth range chosen from the distance to the target.
    Eigen::Matrix4f projection(double aspect) const;
    double nearPlane() const;  ///< [m]
    double farPlane() const;   ///< [m]

    /// Rotates about the target: yaw about up, pitch about the right axis, clamped short of the
    /// poles [rad].
    void orbit(double yaw, double pitch);
    /// Moves eye and target in the view plane; dx, dy as shares of the view height.
    void pan(double dx, double dy);
    /// Scales the distance to the target by `factor`, keeping the world point under `ndc`
    /// (-1..1, y up) in place.
    void zoom(double factor, const Vec2& ndc, double aspect);
    /// Moves along the view direction until `bounds` fills the view.
    void frame(const Bounds& bounds);

    /// World ray through `ndc` (-1..1, y up): origin eye, unit direction.
    Vec3 rayDirection(const Vec2& ndc, double aspect) const;
};

}  // namespace kerf::render

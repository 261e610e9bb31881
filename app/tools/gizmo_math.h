#pragma once

#include "render/scene/camera.h"
#include "sim/base/math.h"

namespace kerf::app {

// What a drag in the picture means in the scene.

/// The position along an axis (unit, through `point`) nearest to a ray [m]. None if the ray is
/// nearly along the axis, so that a pixel would be a large distance.
std::optional<double> alongAxis(const render::Ray& ray, const Vec3& point, const Vec3& axis);

/// The angle about an axis (unit, through `center`) between the points where two rays hit the plane
/// across it [degrees], from -180 to 180. None if one doesn't hit it in front of the eye.
std::optional<double> turnAbout(const Vec3& center, const Vec3& axis, const render::Ray& from,
                                const render::Ray& to);

/// The distance of a pixel from a line between two [px].
double distanceToLine(const Vec2& pixel, const Vec2& from, const Vec2& to);

/// The multiple of `step` nearest to a value.
double snapped(double value, double step);

/// The least of 1, 2, 5, 10, 20 and so on, and of a tenth, hundredth and so on of them, that is no
/// less than `least`, which is above 0.
double roundStep(double least);

}  // namespace kerf::app

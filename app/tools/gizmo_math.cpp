#include "app/tools/gizmo_math.h"

#include <Eigen/Geometry>

namespace kerf::app {
namespace {

constexpr double kSlanted = 0.2;  // sine of the least angle between the line of sight and an axis

/// From the center to where a ray meets the plane across the axis.
std::optional<Vec3> armTo(const Vec3& center, const Vec3& axis, const render::Ray& ray) {
    const double slope = ray.direction.dot(axis);
    const double way = slope == 0 ? -1 : (center - ray.origin).dot(axis) / slope;
    return way > 0 ? std::optional(Vec3(ray.origin + way * ray.direction - center)) : std::nullopt;
}

}  // namespace

std::optional<double> alongAxis(const render::Ray& ray, const Vec3& point, const Vec3& axis) {
    const double along = ray.direction.dot(axis);
    const double square = 1 - along * along;
    if (square < kSlanted * kSlanted) {
        return std::nullopt;
    }
    const Vec3 offset = ray.origin - point;
    return (offset.dot(axis) - along * offset.dot(ray.direction)) / square;
}

std::optional<double> turnAbout(const Vec3& center, const Vec3& axis, const render::Ray& from,
                                const render::Ray& to) {
    const std::optional<Vec3> a = armTo(center, axis, from);
    const std::optional<Vec3> b = armTo(center, axis, to);
    if (!a || !b) {
        return std::nullopt;
    }
    return std::atan2(axis.dot(a->cross(*b)), a->dot(*b)) * 180 / std::numbers::pi;
}

double distanceToLine(const Vec2& pixel, const Vec2& from, const Vec2& to) {
    const Vec2 line = to - from;
    const double square = line.squaredNorm();
    const double share = square > 0 ? std::clamp((pixel - from).dot(line) / square, 0.0, 1.0) : 0.0;
    return (pixel - from - share * line).norm();
}

double snapped(double value, double step) {
    return step * std::round(value / step);
}

double roundStep(double least) {
    const double decade = std::pow(10, std::floor(std::log10(least)));
    for (const double digit : {1.0, 2.0, 5.0}) {
        if (digit * decade >= least * (1 - 1e-9)) {
            return digit * decade;
        }
    }
    return 10 * decade;
}

}  // namespace kerf::app

#include "app/tools/scalpel.h"

namespace kerf::app {

Blade Scalpel::at(const SurfacePoint& point) const {
    return {point.position + lift() * point.normal, point.position - depth_ * point.normal};
}

std::vector<Blade> Scalpel::moveTo(const SurfacePoint& point) {
    if (in_) {
        return {at(point)};
    }
    if (!first_) {
        first_ = point;
        return {};
    }
    const Vec3 way = point.position - first_->position;
    const Vec3 ahead = way - way.dot(first_->normal) * first_->normal;
    if (ahead.norm() < kTell * depth_) {
        return {};
    }
    in_ = true;
    const Blade upright = at(*first_);
    const Vec3 back = -(lift() + depth_) * ahead.normalized();
    // Level and behind, then steep, then upright: the edge swings down through the skin.
    const Blade level{upright.a, upright.a + back};
    const Blade steep{upright.a, upright.a + 0.7071 * (back + (upright.b - upright.a))};
    return {level, steep, upright, at(point)};
}

}  // namespace kerf::app

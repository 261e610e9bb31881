#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <initializer_list>

namespace kerf {

/// Positions in metres, right-handed, +y up. Doubles on the CPU, floats on the GPU.
using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Vec3f = Eigen::Vector3f;

/// Corners of a triangle, counter-clockwise seen from outside.
using Triangle = std::array<int, 3>;

/// An axis-parallel box, empty until something is added.
struct Bounds {
    Vec3 low = Vec3::Constant(1e300);
    Vec3 high = Vec3::Constant(-1e300);
    void add(const Vec3& p) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    void add(const Bounds& other) {
        low = low.cwiseMin(other.low);
        high = high.cwiseMax(other.high);
    }
    /// Moves every side outwards.
    void widen(double margin) {
        low.array() -= margin;
        high.array() += margin;
    }
    bool empty() const { return low.x() > high.x(); }
    /// Touching boxes overlap.
    bool overlaps(const Bounds& other) const {
        return (low.array() <= other.high.array()).all() &&
               (other.low.array() <= high.array()).all();
    }
    Vec3 center() const { return 0.5 * (low + high); }
    /// Corner 0 to 7: bit k of the index takes the high side along axis k.
    Vec3 corner(int index) const {
        return {index & 1 ? high.x() : low.x(), index & 2 ? high.y() : low.y(),
                index & 4 ? high.z() : low.z()};
    }
    double diagonal() const { return empty() ? 0.0 : (high - low).norm(); }
};

/// The float nearest to `x`, as the GPU will hold it. Through a volatile: with optimisation GCC 12
/// (12.2, its vectoriser of straight-line code) leaves (double)(float)x as x where two of them
/// stand side by side.
inline double nearestFloat(double x) {
    const volatile float rounded = static_cast<float>(x);
    return rounded;
}

/// The vector of floats nearest to `a`, component by component.
inline Vec3 nearestFloats(const Vec3& a) {
    return {nearestFloat(a.x()), nearestFloat(a.y()), nearestFloat(a.z())};
}

/// The box of points or boxes: of the items themselves, or of what `place` gives for each [m].
template <class Items = std::initializer_list<Vec3>, class Place = std::identity>
Bounds boxOf(const Items& items, Place place = {}) {
    Bounds box;
    for (const auto& item : items) {
        box.add(std::invoke(place, item));
    }
    return box;
}

/// The box with every side moved outwards.
inline Bounds widened(Bounds box, double margin) {
    box.widen(margin);
    return box;
}

}  // namespace kerf

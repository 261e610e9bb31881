#include "sim/contact/blade_body.h"

#include <cassert>

namespace kerf {

namespace {

constexpr double kAhead = 0.7071;        // cosine: within 45 degrees
constexpr double kStandingStill = 1e-9;  // of the blade's length
constexpr double kLeastAcross = 0.1;     // of a unit vector: closer to AB it has no direction
// Of what lies behind the front: the box that stands for the blade begins no farther back.
constexpr double kLongestBevel = 0.8;

Vec3 middle(const Blade& blade) {
    return 0.5 * (blade.a + blade.b);
}

Vec3 directionOf(const Blade& blade) {
    return (blade.b - blade.a).normalized();
}

Vec3 across(const Vec3& v, const Vec3& along) {
    return v - along * along.dot(v);
}

/// Square to `along`, or zero where it runs along it.
Vec3 squared(const Vec3& direction, const Vec3& along) {
    const Vec3 square = across(direction, along);
    return square.norm() > kLeastAcross ? Vec3(square.normalized()) : Vec3(Vec3::Zero());
}

BladeFrame frameBetween(const BladeTrail& from, const BladeTrail& to, double t) {
    const Blade edge = interpolate(from.edge, to.edge, t);
    const Vec3 along = directionOf(edge);
    const Vec3 first = from.back.isZero() ? to.back : from.back;
    Vec3 back = across(first + t * (to.back - first), along);
    back = back.norm() > kLeastAcross ? Vec3(back.normalized()) : to.back;
    BladeFrame frame;
    frame.origin = middle(edge);
    frame.axes << along, back, along.cross(back);
    frame.halfLength = 0.5 * (edge.b - edge.a).norm();
    return frame;
}

BladeFrame frameAt(std::span<const BladeTrail> trails, double t) {
    if (trails.size() == 1) {
        return frameBetween(trails[0], trails[0], 0);
    }
    const double place = t * static_cast<double>(trails.size() - 1);
    const auto leg = std::min(static_cast<std::size_t>(place), trails.size() - 2);
    return frameBetween(trails[leg], trails[leg + 1], place - static_cast<double>(leg));
}

}  // namespace

BladeTrail ledTo(const BladeTrail& trail, const Blade& to, double width) {
    const Vec3 along = directionOf(to);
    const Vec3 move = across(middle(to) - middle(trail.edge), along);
    BladeTrail next{to, squared(trail.back, along), trail.way, trail.farthest};
    if (next.back.isZero()) {
        next.way = next.farthest = 0;
    }
    if (move.norm() <= kStandingStill * (to.b - to.a).norm()) {
        return next;
    }
    const double towed = std::min(width, next.farthest);
    if (towed < width || -move.dot(next.back) >= kAhead * move.norm()) {
        next.back = squared((towed * next.back - move).normalized(), along);
    }
    next.way -= move.dot(next.back);
    next.farthest = std::max(next.farthest, next.way);
    return next;
}

double BladeMotion::halfAt(double y) const {
    return halfThickness * std::clamp((y - front) / bevel, 0.0, 1.0);
}

double BladeMotion::shoulder() const {
    return front + std::min(bevel, kLongestBevel * (back - front));
}

Vec3 BladeMotion::middle() const {
    const double y = 0.5 * (shoulder() + back);
    const auto at = [y](const BladeFrame& frame) -> Vec3 {
        return frame.origin + y * frame.axes.col(1);
    };
    return 0.5 * (at(frames.front()) + at(frames.back()));
}

Bounds BladeMotion::bounds() const {
    Bounds box;
    for (const BladeFrame& frame : frames) {
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 at = Bounds{
                {-frame.halfLength, front, -halfThickness},
                {frame.halfLength, back,
                 halfThickness}}.corner(corner);
            box.add(frame.origin + frame.axes * at);
        }
    }
    return box;
}

BladeMotion motionOf(std::span<const BladeTrail> trails, const BladeSize& size, double front,
                     double leastBevel, int substeps) {
    assert(!trails.empty() && substeps > 0);
    BladeMotion motion;
    motion.front = front;
    motion.back = trails.front().widthOf(size);
    motion.bevel = std::max(kBladeBevel * size.width, leastBevel);
    motion.halfThickness = 0.5 * size.thickness;
    for (int i = 0; i <= substeps; ++i) {
        motion.frames.push_back(frameAt(trails, i / static_cast<double>(substeps)));
    }
    return motion;
}

}  // namespace kerf

#include "sim/run/parts/led_blade.h"

#include <cassert>

namespace kerf {

std::string checkBlade(const Blade& blade) {
    if (!blade.a.allFinite() || !blade.b.allFinite()) {
        return "The blade needs finite coordinates for both ends; it stays where it was.";
    }
    if (blade.a == blade.b) {
        return "The two ends of the blade are the same point; give it a length.";
    }
    return "";
}

bool standsInMaterial(const std::vector<RungNode>& rung) {
    return std::ranges::any_of(rung, [](const RungNode& node) { return node.vertex >= 0; });
}

std::optional<Blade> LedBlade::pose() const {
    return trail_ ? std::optional(trail_->edge) : std::nullopt;
}

std::optional<Blade> LedBlade::comingPose() const {
    if (coming_.empty()) {
        return pose();
    }
    const auto* const move = std::get_if<MoveBlade>(&coming_.back());
    return move != nullptr ? std::optional(move->blade) : std::nullopt;
}

bool LedBlade::isAt(const Blade& pose) const {
    return trail_ && trail_->edge.a == pose.a && trail_->edge.b == pose.b;
}

BladeTrail LedBlade::trailTo(const Blade& to, double width) const {
    return trail_ ? ledTo(*trail_, to, width) : BladeTrail{to};
}

void LedBlade::moveTo(const Blade& to, double width, const Blade& edge) {
    trail_ = trailTo(to, width);
    edge_ = edge;
}

Blade LedBlade::edgeAt(const Blade& to, double lag) const {
    if (lag <= 0 || !trail_) {
        return to;
    }
    const auto follow = [&](const Vec3& from, const Vec3& end) -> Vec3 {
        const Vec3 string = cut::across(to, from - end);
        return end + string * (lag / std::max(string.norm(), lag));
    };
    return {follow(edge_->a, to.a), follow(edge_->b, to.b)};
}

Blade LedBlade::nextPose() const {
    Blade pose = trail_->edge;
    for (const BladeAction& action : coming_) {
        const auto* move = std::get_if<MoveBlade>(&action);
        if (move == nullptr) {
            break;
        }
        pose = move->blade;
    }
    return pose;
}

double LedBlade::comingWay() const {
    const Blade from = trail_->edge;
    const Blade to = nextPose();
    return std::max((to.a - from.a).norm(), (to.b - from.b).norm());
}

std::vector<Blade> LedBlade::path() const {
    std::vector<Blade> path;
    if (trail_) {
        path.push_back(*edge_);
    }
    if (trail_ && !(edge_->a == trail_->edge.a && edge_->b == trail_->edge.b)) {
        path.push_back(trail_->edge);
    }
    for (const BladeAction& action : coming_) {
        if (const auto* move = std::get_if<MoveBlade>(&action)) {
            path.push_back(move->blade);
        }
    }
    return path;
}

std::optional<BladeMotion> LedBlade::body(const BladePush& push) const {
    if (!trail_ || trail_->farthest <= 0) {
        return std::nullopt;
    }
    return motionOf(std::array{*trail_}, push.size, 0, push.wallEdge, 1);
}

std::optional<BladeMotion> LedBlade::motion(const BladePush& push,
                                            const std::vector<RungNode>& front) const {
    assert(isPlaced());
    std::vector<BladeTrail> trails{*trail_};
    for (const BladeAction& action : coming_) {
        const auto* move = std::get_if<MoveBlade>(&action);
        if (move == nullptr) {
            break;
        }
        trails.push_back(ledTo(trails.back(), move->blade, push.size.width));
    }
    BladeMotion motion = motionOf(trails, push.size, lagOfBody(trails.back(), front, push.frontLag),
                                  push.wallEdge, push.substeps);
    return motion.back > motion.front ? std::optional(std::move(motion)) : std::nullopt;
}

/// How far behind the edge at the end of a step its body begins: not before where the edge has cut.
double LedBlade::lagOfBody(const BladeTrail& end, const std::vector<RungNode>& front,
                           double frontLag) const {
    double lag = 0;
    const auto keepBehind = [&](const Vec3& p, double s) {
        const Vec3 edge = end.edge.a + s * (end.edge.b - end.edge.a);
        lag = std::max(lag, end.back.dot(p - edge));
    };
    keepBehind(trail_->edge.a, 0);
    keepBehind(trail_->edge.b, 1);
    // A front that waits at the gate and one that has just been cut are one to the plate: it comes
    // on evenly.
    const double mostLag = lag + frontLag;
    for (const RungNode& node : front) {
        keepBehind(node.position, node.s);
    }
    return standsInMaterial(front) ? std::max(lag, mostLag) : lag;
}

}  // namespace kerf

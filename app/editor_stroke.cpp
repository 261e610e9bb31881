#include "app/editor_stroke.h"

#include <algorithm>
#include <cmath>

namespace kerf::app {
namespace {

constexpr double kMaxStepShare = 1.0 / 60;  // of the body's diagonal
constexpr double kMinStepShare = 0.25;      // of the longest step: shorter moves are gathered
constexpr double kOvershoot = 0.5;          // of the diagonal, beyond the body at both ends
constexpr double kNearestShare = 0.05;      // of the distance to the body: A stays before the eye

}  // namespace

StrokeSpace::StrokeSpace(const render::Camera& camera, double aspect, const Bounds& bounds)
    : camera_(camera), aspect_(aspect), forward_((camera.target - camera.eye).normalized()) {
    const double diagonal = std::max(bounds.diagonal(), 1e-9);
    const double middle = std::max((bounds.center() - camera.eye).dot(forward_), 0.1 * diagonal);
    const double reach = (0.5 + kOvershoot) * diagonal;
    nearDepth_ = std::max(middle - reach, kNearestShare * middle);
    farDepth_ = middle + reach;
    middleShare_ = (middle - nearDepth_) / (farDepth_ - nearDepth_);
    maxStep_ = kMaxStepShare * diagonal;
}

Blade StrokeSpace::bladeAt(const Vec2& ndc) const {
    const Vec3 ray = camera_.rayDirection(ndc, aspect_);
    const double perDepth = 1 / ray.dot(forward_);
    return {camera_.eye + ray * (nearDepth_ * perDepth),
            camera_.eye + ray * (farDepth_ * perDepth)};
}

double StrokeSpace::distance(const Blade& from, const Blade& to) const {
    const auto middle = [&](const Blade& blade) {
        return Vec3(blade.a + (blade.b - blade.a) * middleShare_);
    };
    return (middle(to) - middle(from)).norm();
}

void BladeStroke::begin(const StrokeSpace& space, const Vec2& ndc) {
    space_ = space;
    queued_.reset();
    first_ = latest_ = space.bladeAt(ndc);
}

void BladeStroke::moveTo(const Vec2& ndc) {
    if (!drawing()) {
        return;
    }
    latest_ = space_->bladeAt(ndc);
    const double gathered = space_->distance(placed() ? *queued_ : first_, latest_);
    if (gathered < kMinStepShare * space_->maxStep()) {
        return;
    }
    if (!placed()) {
        queue_.emplace_back(MoveBlade{first_});
        queued_ = first_;
    }
    queueUpTo(latest_);
}

void BladeStroke::queueUpTo(const Blade& target) {
    const Blade from = *queued_;
    const double length = space_->distance(from, target);
    const int steps = std::max(1, static_cast<int>(std::ceil(length / space_->maxStep())));
    for (int k = 1; k <= steps; ++k) {
        queue_.emplace_back(
            MoveBlade{k == steps ? target : interpolate(from, target, double(k) / steps)});
    }
    queued_ = target;
}

void BladeStroke::end() {
    if (drawing() && placed()) {
        if (space_->distance(*queued_, latest_) > 0) {
            queueUpTo(latest_);
        }
        queue_.emplace_back(LiftBlade{});
    }
    space_.reset();
    queued_.reset();
}

void BladeStroke::cancel() {
    queue_.clear();
    if (!sweep_.empty()) {
        queue_.emplace_back(LiftBlade{});
    }
    space_.reset();
    queued_.reset();
}

std::optional<Command> BladeStroke::next() {
    if (queue_.empty()) {
        return std::nullopt;
    }
    Command command = std::move(queue_.front());
    queue_.pop_front();
    if (const auto* move = std::get_if<MoveBlade>(&command)) {
        sweep_.push_back(move->blade);
    } else {
        sweep_.clear();
    }
    return command;
}

}  // namespace kerf::app

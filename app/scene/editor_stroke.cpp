#include "app/scene/editor_stroke.h"

namespace kerf::app {
namespace {

constexpr double kMaxStepShare = 1.0 / 60;  // of the body's diagonal
constexpr double kMinStepShare = 0.25;      // of the longest step: shorter moves are gathered
constexpr double kMinTimedShare = 0.06;     // the same where time is kept
constexpr double kMostRest = 0.25;          // of a hand at rest, that is simulated [s]
constexpr double kMostSeconds = 3600;       // of a pose, in sessions
constexpr double kOvershoot = 0.5;          // of the diagonal, beyond the body at both ends
constexpr double kMinBladeShare = 0.01;     // of the diagonal
constexpr double kLeastDiagonal = 1e-9;     // [m]
constexpr double kNearestShare = 0.05;      // of the distance to the body: A stays before the eye

}  // namespace

double StrokeScale::distance(const Blade& from, const Blade& to) const {
    const auto point = [&](const Blade& blade) {
        return Vec3(blade.a + (blade.b - blade.a) * share);
    };
    return (point(to) - point(from)).norm();
}

double maxStrokeStep(const Bounds& bounds) {
    return kMaxStepShare * std::max(bounds.diagonal(), kLeastDiagonal);
}

StrokeSpace::StrokeSpace(const render::Camera& camera, double aspect, const Bounds& bounds,
                         std::optional<double> depth)
    : camera_(camera), aspect_(aspect), forward_(camera.forward()) {
    const double diagonal = std::max(bounds.diagonal(), kLeastDiagonal);
    double middle = (bounds.center() - camera.eye).dot(forward_);
    const double reach = (0.5 + kOvershoot) * diagonal;
    nearDepth_ = middle - reach;
    if (!camera.orthographic) {
        middle = std::max(middle, 0.1 * diagonal);
        nearDepth_ = std::max(middle - reach, kNearestShare * middle);
    }
    farDepth_ = depth ? nearestDepth(bounds) + *depth : middle + reach;
    farDepth_ = std::max(farDepth_, nearDepth_ + kMinBladeShare * diagonal);
    middleShare_ = std::min((middle - nearDepth_) / (farDepth_ - nearDepth_), 1.0);
    maxStep_ = maxStrokeStep(bounds);
}

/// Where the ellipsoid in the bounds comes nearest to the eye, along the view direction [m]: bodies
/// hardly fill the corners of their boxes.
double StrokeSpace::nearestDepth(const Bounds& bounds) const {
    const Vec3 half = 0.5 * (bounds.high - bounds.low);
    return (bounds.center() - camera_.eye).dot(forward_) - half.cwiseProduct(forward_).norm();
}

Blade StrokeSpace::bladeAt(const Vec2& ndc) const {
    return {camera_.pointAt(ndc, aspect_, nearDepth_), camera_.pointAt(ndc, aspect_, farDepth_)};
}

void BladeStroke::begin(const Blade& first, const StrokeScale& scale) {
    space_.reset();
    scale_ = scale;
    away_ = keepsTime() ? elapsed_ : 0;
    elapsed_ = 0;
    owed_ = 0;
    queued_.reset();
    first_ = latest_ = first;
}

void BladeStroke::begin(const StrokeSpace& space, const Vec2& ndc) {
    begin(space.bladeAt(ndc), space.scale());
    space_ = space;
}

void BladeStroke::moveTo(const Vec2& ndc) {
    if (space_) {
        moveTo(space_->bladeAt(ndc));
    }
}

void BladeStroke::moveTo(const Blade& blade) {
    if (!drawing()) {
        return;
    }
    latest_ = blade;
    const Blade& last = !way_.empty() ? way_.back() : placed() ? *queued_ : first_;
    const double gathered = (keepsTime() ? kMinTimedShare : kMinStepShare) * scale_->maxStep;
    if (scale_->distance(last, latest_) < gathered) {
        return;
    }
    way_.push_back(latest_);
    if (!keepsTime()) {
        queueWay();
    }
}

void BladeStroke::elapse(double seconds) {
    if (keepsTime() && elapsed_ >= timeStep_) {
        queueWay();
    }
    elapsed_ += drawing() || keepsTime() ? seconds : 0;
}

int BladeStroke::stepsFor(double length, double seconds) {
    const double farthest = std::min(scale_->maxStep, farthest_);
    const int steps = std::max(1, static_cast<int>(std::ceil(length / farthest)));
    owed_ += keepsTime() ? std::min(seconds, kMostRest) / timeStep_ : 0;
    const int queued = std::max(steps, static_cast<int>(owed_));
    owed_ = std::max(0.0, owed_ - queued);
    return queued;
}

/// Poses at equal distances, which share the time.
void BladeStroke::queueWay() {
    if (way_.empty()) {
        return;
    }
    if (!placed()) {
        const double away = std::min(std::exchange(away_, 0), kMostSeconds);
        queue_.emplace_back(MoveBlade{first_, away > 0 ? std::optional(away) : std::nullopt});
        queued_ = first_;
    }
    way_.insert(way_.begin(), *queued_);
    std::vector<double> ends{0};
    for (std::size_t i = 1; i < way_.size(); ++i) {
        ends.push_back(ends.back() + scale_->distance(way_[i - 1], way_[i]));
    }
    const double elapsed = std::min(std::exchange(elapsed_, 0), kMostSeconds);
    const int steps = stepsFor(ends.back(), elapsed);
    const auto seconds = elapsed > 0 ? std::optional(elapsed / steps) : std::nullopt;
    for (int k = 1; k <= steps; ++k) {
        const double at = ends.back() * k / steps;
        const auto to =
            std::find_if(ends.begin() + 1, ends.end() - 1, [at](double end) { return end >= at; }) -
            ends.begin();
        const double length = ends[to] - ends[to - 1];
        const bool arrives = k == steps || length == 0;
        queue_.emplace_back(MoveBlade{
            arrives ? way_[to] : interpolate(way_[to - 1], way_[to], (at - ends[to - 1]) / length),
            seconds});
    }
    queued_ = way_.back();
    way_.clear();
}

void BladeStroke::end() {
    const bool begun = placed() || !way_.empty();
    if (drawing() && begun) {
        const Blade& last = way_.empty() ? *queued_ : way_.back();
        if (scale_->distance(last, latest_) > 0 || (keepsTime() && elapsed_ > 0)) {
            way_.push_back(latest_);
        }
        queueWay();
        queue_.emplace_back(LiftBlade{});
    }
    forgetPointer();
}

void BladeStroke::cancel() {
    queue_.clear();
    if (done_) {
        queue_.emplace_back(LiftBlade{});
    }
    forgetPointer();
}

void BladeStroke::forgetPointer() {
    space_.reset();
    scale_.reset();
    queued_.reset();
    way_.clear();
    elapsed_ += std::exchange(away_, 0);
}

int BladeStroke::waiting() const {
    const auto lifts = std::ranges::count_if(
        queue_, [](const Command& command) { return std::holds_alternative<LiftBlade>(command); });
    return std::max(0, static_cast<int>(lifts) - (done_ ? 1 : 0));
}

std::optional<Command> BladeStroke::next() {
    if (queue_.empty()) {
        return std::nullopt;
    }
    Command command = std::move(queue_.front());
    queue_.pop_front();
    given_ = queue_.empty() ? 0 : given_ + 1;
    const auto* move = std::get_if<MoveBlade>(&command);
    done_ = move != nullptr ? std::optional(move->blade) : std::nullopt;
    return command;
}

std::vector<Blade> BladeStroke::wayAhead() const {
    std::vector<Blade> way;
    if (done_) {
        way.push_back(*done_);
    } else if (drawing() && !placed()) {
        way.push_back(first_);
    }
    for (const Command& command : queue_) {
        const auto* move = std::get_if<MoveBlade>(&command);
        if (move == nullptr) {
            way.clear();  // of the stroke before
        } else {
            way.push_back(move->blade);
        }
    }
    way.insert(way.end(), way_.begin(), way_.end());
    if (drawing()) {
        way.push_back(latest_);
    }
    return way;
}

}  // namespace kerf::app

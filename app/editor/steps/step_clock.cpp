#include "app/editor/steps/step_clock.h"

#include "app/scene/editor_scene.h"
#include "app/scene/timeline/scene_timeline.h"
#include "sim/base/pausing.h"

namespace kerf::app {

namespace {

constexpr double kMostBehind = 0.1;           // by which steps may be late; the rest is dropped [s]
constexpr double kStepBudgetSeconds = 0.012;  // more than one step only while they are this fast
constexpr double kNeededBudgetSeconds = 0.1;  // the same for steps without which a hand waits
constexpr double kSeekBudgetSeconds = 0.2;    // the same for those that are not drawn

constexpr double kWindow = 10;  // of which the rate is taken [s]
constexpr double kSettles = 4;  // within which the estimate takes up a new rate [s]

}  // namespace

void StepClock::setSpeed(double factor) {
    speed_ = std::clamp(factor, kSlowest, kFastest);
}

void StepClock::elapse(double seconds) {
    sinceDue_ += seconds;
    sinceShown_ += seconds;
}

void StepClock::passTime(double timeStep) {
    const double elapsed = std::exchange(sinceDue_, 0);
    const double more = byTheClock_ ? elapsed / timeStep : 1;
    due_ = std::min(due_ + speed_ * more, std::max(1.0, speed_) * (1 + kMostBehind / timeStep));
}

void StepClock::run(EditorScene& scene, int needed, int most) {
    const WorkWatch watch;
    int done = 0;
    const bool seeks = scene.timeline().seekSteps() > 0;
    const auto mayGoOn = [&] {
        const double budget = done < needed ? kNeededBudgetSeconds
                              : seeks       ? kSeekBudgetSeconds
                                            : kStepBudgetSeconds;
        return !byTheClock_ || done == 0 || watch.seconds() < budget;
    };
    for (; done < std::max(needed, most) && mayGoOn(); ++done) {
        scene.step();
    }
    due_ = std::max(0.0, due_ - done);
    stepSeconds_ += watch.seconds();
    secondsPerStep_ = done > 0 ? watch.seconds() / done : secondsPerStep_;
}

bool StepClock::isSlow() const {
    return byTheClock_ && secondsPerStep_ > kStepBudgetSeconds;
}

double StepClock::portion() const {
    return byTheClock_ ? portion_ : std::numeric_limits<double>::infinity();
}

void StepClock::stop() {
    due_ = 0;
    sinceDue_ = 0;
    ranBefore_ = false;
}

void StepClock::begin() {
    stop();
    secondsPerStep_ = 0;
}

FrameTime StepClock::measure() {
    const double seconds = std::exchange(sinceShown_, 0);
    const double steps = std::exchange(stepSeconds_, 0);
    const bool isFrame = std::exchange(ranBefore_, true) && seconds > 0;
    return isFrame ? FrameTime{seconds, steps} : FrameTime{};
}

void TimeLeft::follow(ui::WorkState& work) {
    if (std::exchange(title_, work.title) != work.title) {
        *this = {};
        title_ = work.title;
    }
    work.seconds = std::max(work.seconds, watch_.seconds());
    work.left = at(work.seconds, work.done, work.all);
}

std::optional<double> TimeLeft::at(double seconds, double done, double all) {
    note({seconds, done});
    const double parts = samples_.back().done - samples_.front().done;
    if (all <= 0 || parts <= 0) {
        return left_ = std::nullopt;
    }
    const double each = (samples_.back().seconds - samples_.front().seconds) / parts;
    const double byRate = std::max(0.0, each * (all - done) - (seconds - samples_.back().seconds));
    const double passed = seconds - std::exchange(last_, seconds);
    const double runsDown = std::max(0.0, left_.value_or(byRate) - passed);
    return left_ = runsDown + (byRate - runsDown) * (1 - std::exp(-passed / kSettles));
}

/// Keeps two samples at least, however old.
void TimeLeft::note(const Sample& now) {
    if (samples_.empty() || now.done < samples_.back().done) {
        samples_ = {now};
    } else if (now.done > samples_.back().done) {
        samples_.push_back(now);
    }
    while (samples_.size() > 2 && samples_[1].seconds < now.seconds - kWindow) {
        samples_.pop_front();
    }
}

}  // namespace kerf::app

#include "app/editor/steps/step_clock.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "app/scene/editor_scene.h"
#include "app/scene/timeline/scene_timeline.h"
#include "sim/base/pausing.h"

namespace kerf::app {
namespace {

constexpr double kMostDue = 4;                // steps, at speed 1
constexpr double kStepBudgetSeconds = 0.012;  // more than one step only while they are this fast
constexpr double kNeededBudgetSeconds = 0.1;  // the same for steps without which a hand waits
constexpr double kSeekBudgetSeconds = 0.2;    // the same for those that are not drawn

}  // namespace

void StepClock::setSpeed(double factor) {
    speed_ = std::clamp(factor, kSlowest, kFastest);
}

void StepClock::elapse(double seconds) {
    sinceDue_ += seconds;
    sinceShown_ += seconds;
}

int StepClock::takeDue(double timeStep) {
    const double elapsed = std::exchange(sinceDue_, 0);
    const double more = byTheClock_ ? elapsed / timeStep : 1;
    due_ = std::min(due_ + speed_ * more, kMostDue * std::max(1.0, speed_));
    const int whole = static_cast<int>(due_);
    due_ -= whole;
    return whole;
}

void StepClock::run(EditorScene& scene, int needed, int due) {
    const WorkWatch watch;
    int done = 0;
    const bool seeks = scene.timeline().seekSteps() > 0;
    const auto mayGoOn = [&] {
        const double budget = done < needed ? kNeededBudgetSeconds
                              : seeks       ? kSeekBudgetSeconds
                                            : kStepBudgetSeconds;
        return !byTheClock_ || done == 0 || watch.seconds() < budget;
    };
    for (; done < std::max(needed, due) && mayGoOn(); ++done) {
        scene.step();
    }
    secondsPerStep_ = done > 0 ? watch.seconds() / done : secondsPerStep_;
}

double StepClock::portion() const {
    return byTheClock_ ? portion_ : std::numeric_limits<double>::infinity();
}

void StepClock::stop() {
    due_ = 0;
    sinceDue_ = 0;
    ranBefore_ = false;
}

std::optional<double> StepClock::measure() {
    const double seconds = std::exchange(sinceShown_, 0);
    const bool isFrame = std::exchange(ranBefore_, true) && seconds > 0;
    return isFrame ? std::optional(seconds) : std::nullopt;
}

}  // namespace kerf::app

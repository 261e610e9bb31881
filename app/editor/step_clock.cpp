#include "app/editor/step_clock.h"

#include <algorithm>
#include <utility>

#include "app/scene/editor_scene.h"
#include "sim/base/stopwatch.h"

namespace kerf::app {
namespace {

constexpr double kMostDue = 4;                // steps, at speed 1
constexpr double kStepBudgetSeconds = 0.012;  // more than one step only while they are this fast

}  // namespace

void StepClock::setSpeed(double factor) {
    speed_ = std::clamp(factor, kSlowest, kFastest);
}

int StepClock::takeDue(double elapsedSeconds, double timeStep) {
    const double more = byTheClock_ ? elapsedSeconds / timeStep : 1;
    due_ = std::min(due_ + speed_ * more, kMostDue * std::max(1.0, speed_));
    const int whole = static_cast<int>(due_);
    due_ -= whole;
    return whole;
}

void StepClock::run(EditorScene& scene, int needed, int due) const {
    const Stopwatch watch;
    for (int n = 0; n < std::max(needed, due); ++n) {
        if (n >= std::max(1, needed) && byTheClock_ && watch.seconds() > kStepBudgetSeconds) {
            return;
        }
        scene.step();
    }
}

bool StepClock::measure(double elapsedSeconds, bool ran) {
    // Only between two pictures that both ran: a pause in between is no frame time.
    return std::exchange(ranBefore_, ran) && ran && elapsedSeconds > 0;
}

}  // namespace kerf::app

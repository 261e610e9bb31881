#include <spdlog/spdlog.h>

#include <algorithm>

#include "app/editor/editor_state.h"
#include "sim/base/stopwatch.h"

namespace kerf::app {
namespace {

constexpr double kStepBudgetSeconds = 0.012;  // more than one step only while they are this fast
constexpr int kMostSeekSteps = 64;            // per picture, while they are fast

}  // namespace

bool Editor::State::running() const {
    return scene != nullptr && (scene->playing || scene->pulling() ||
                                scene->stroke().pending() > 0 || scene->seekSteps() > 0);
}

void Editor::State::runSteps(int needed, int due) {
    const Stopwatch watch;
    for (int n = 0; n < std::max(needed, due); ++n) {
        const bool late = options.byTheClock && watch.seconds() > kStepBudgetSeconds;
        if (late && n >= std::max(1, needed)) {
            break;
        }
        scene->step();
    }
    sceneChanged = true;
    settleUpdates = kSettleUpdates;  // the panels show a step one update later
    for (const std::string& message : scene->takeMessages()) {
        spdlog::warn("{}", message);
        toast.show(message, false);
    }
}

void Editor::State::advance(double elapsedSeconds) {
    const bool ran = running();
    if (ran) {
        joinPieces();
        const bool playing = scene->playing || scene->pulling();
        const double timeStep = scene->simulation().params().timeStep;
        const int due = playing ? clock.takeDue(elapsedSeconds, timeStep) : 0;
        runSteps(scene->strokeSteps(), std::max(due, std::min(scene->seekSteps(), kMostSeekSteps)));
    }
    const double renderMs = sceneTimer.takeMilliseconds();
    if (clock.measure(elapsedSeconds, ran)) {
        scene->recordPicture(elapsedSeconds, renderMs);
        experiments.note(*scene);
    }
}

}  // namespace kerf::app

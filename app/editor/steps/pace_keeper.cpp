#include "app/editor/steps/pace_keeper.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/scene/editor_scene.h"
#include "app/scene/readout/scene_readout.h"
#include "app/scene/timeline/scene_timeline.h"

namespace kerf::app {
namespace {

constexpr std::array kSteps{0.001, 0.002, 0.005, 0.01};  // [s]
constexpr double kFiner = 1.3;          // times as many iterations, from one choice to the next
constexpr double kLook = 1;             // between two looks [s]
constexpr int kLeastSteps = 4;          // the same
constexpr double kSpare = 1.25;         // real-time factor of a choice that keeps pace
constexpr double kWorth = 1.2;          // by which a finer choice must take longer
constexpr double kOfSteps = 0.75;       // of the clock; pictures have the rest
constexpr double kMostOfVolume = 0.01;  // that a body may gain or lose
constexpr int kMostDoubled = 32;        // of the fewest iterations
constexpr double kTold = 0.02;          // what lacks in stiffness from which on it is told

StepDivision divisionOf(const Params& params) {
    return {params.timeStep, params.iterations};
}

Params with(Params params, const StepDivision& steps) {
    params.timeStep = steps.timeStep;
    params.iterations = steps.iterations;
    return params;
}

/// From coarse to fine.
std::vector<StepDivision> divisionsOf(const SweepStrength& sweeps, const Params& accurate,
                                      int fewest) {
    std::vector<StepDivision> all;
    for (auto h = kSteps.rbegin(); h != kSteps.rend(); ++h) {
        const Params tried = with(accurate, {std::max(*h, accurate.timeStep), accurate.iterations});
        const int most = accurate.iterations == kAutoIterations ? sweeps.iterationsFor(tried, 0)
                                                                : accurate.iterations;
        for (double n = std::min(fewest, most); n < kFiner * most; n *= kFiner) {
            all.push_back({tried.timeStep, std::min(most, static_cast<int>(std::lround(n)))});
        }
    }
    return all;
}

}  // namespace

StepDivision keepingPace(const SweepStrength& sweeps, const Params& accurate, const StepCost& cost,
                         int fewest) {
    const std::vector<StepDivision> all = divisionsOf(sweeps, accurate, fewest);
    StepDivision best = all.front();
    double least = sweeps.error(with(accurate, best));
    for (const StepDivision& steps : all) {
        const double error = sweeps.error(with(accurate, steps));
        if (cost.factor(steps) >= kSpare && error < least) {
            best = steps;
            least = error;
        }
    }
    return best;
}

void PaceKeeper::toggle(EditorScene& scene) {
    on_ = !on_;
    if (!on_ && before_) {
        take(scene, divisionOf(*std::exchange(before_, std::nullopt)));
    }
}

void PaceKeeper::follow(EditorScene& scene, const FrameTime& frame) {
    const Simulation& now = scene.simulation();
    if (!on_ || scene.timeline().playingBack() || scene.document().session.task) {
        return;
    }
    if (!before_) {
        before_ = now.params();
        takeCoarsest(scene);
    } else if (const StepDivision set = divisionOf(now.params()); set != taken_) {
        on_ = false;
        const StepDivision before = divisionOf(*std::exchange(before_, std::nullopt));
        take(scene, {set.timeStep == taken_.timeStep ? before.timeStep : set.timeStep,
                     set.iterations == taken_.iterations ? before.iterations : set.iterations});
    } else if (std::abs(now.report().volumeRatio - 1) > kMostOfVolume && fewest_ < kMostDoubled &&
               taken_.iterations <= fewest_) {
        fewest_ *= 2;
        takeCoarsest(scene);
    } else {
        look(scene, frame);
    }
}

/// Now and then.
void PaceKeeper::look(EditorScene& scene, const FrameTime& frame) {
    passed_.all += frame.all;
    passed_.steps += frame.steps;
    const StepReport& report = scene.simulation().report();
    const int steps = scene.simulation().stepCount() - fromStep_;
    if (steps >= 0 && (passed_.all < kLook || steps < kLeastSteps)) {
        return;
    }
    const double busy = 0.001 * (report.times.deform + report.times.collide);
    if (steps > 0 && busy > 0) {  // else it sleeps, which tells nothing
        const double step = passed_.steps / steps;
        const double sweeps = std::min(step, busy);
        const StepCost cost{(step - sweeps) / kOfSteps, sweeps / taken_.iterations / kOfSteps};
        const StepDivision better = keepingPace(scene.readout().sweeps(), *before_, cost, fewest_);
        const double gain = cost.factor(better) / cost.factor(taken_);
        if (cost.factor(taken_) < 1 ? gain > 1 : gain < 1 / kWorth) {
            take(scene, better);
        }
    }
    count(scene);
}

void PaceKeeper::takeCoarsest(EditorScene& scene) {
    take(scene, keepingPace(scene.readout().sweeps(), *before_, {1, 0}, fewest_));
}

/// Counts from now on.
void PaceKeeper::count(const EditorScene& scene) {
    passed_ = {};
    fromStep_ = scene.simulation().stepCount();
}

void PaceKeeper::take(EditorScene& scene, const StepDivision& steps) {
    taken_ = steps;
    const Params params = with(scene.simulation().params(), steps);
    for (const char* name : {"time_step", "iterations"}) {
        const ParamValue value = getParam(params, name);
        if (value != getParam(scene.simulation().params(), name)) {
            scene.execute(SetParam{name, value, true});
        }
    }
    count(scene);
}

std::string PaceKeeper::cost(const SweepStrength& sweeps, const Params& now) const {
    if (!on_) {
        return "";
    }
    const double lacks = 1 - sweeps.carried(now);
    return lacks < kTold ? "as stiff as set" : fmt::format("about {:.0f} % too soft", 100 * lacks);
}

}  // namespace kerf::app

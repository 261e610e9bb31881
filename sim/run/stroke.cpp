// The course of a stroke: it begins when the blade comes near the body, and ends when it has left
// it.
#include "sim/base/stopwatch.h"
#include "sim/run/simulation_state.h"

namespace kerf {

void Simulation::State::cutAll() {
    if (!blade.isTold()) {
        return;
    }
    const Stopwatch watch;
    for (const BladeAction& action : blade.takeActions()) {
        std::visit([this](const auto& a) { cut(a); }, action);
    }
    report.cutMs = watch.milliseconds();
}

void Simulation::State::cut(const MoveBlade& move) {
    if (blade.isAt(move.blade)) {
        return;
    }
    if (blade.isPlaced() && mayTouch(move.blade)) {
        if (!body.cutter->inStroke()) {
            beginStroke();
        }
        accept(body.cutter->advance(move.blade));
    } else {
        endStroke();
    }
    blade.moveTo(move.blade, bladePush().size.width);
}

void Simulation::State::cut(const LiftBlade&) {
    if (blade.lift()) {
        endStroke();
    }
    log.endStroke();
}

/// Whether the cutter must look: a front is in the material, or the strip comes near the body.
bool Simulation::State::mayTouch(const Blade& to) {
    const std::vector<RungNode>& rung = body.cutter->rung();
    const Blade from = *blade.pose();
    std::vector<Vec3> strip{from.a, from.b, to.a, to.b};
    for (const RungNode& node : rung) {
        strip.push_back(node.position);
    }
    return standsInMaterial(rung) || body.isNear(strip);
}

void Simulation::State::beginStroke() {
    if (log.strokeNeedsSnapshot()) {
        log.beginStroke(captureForUndo());
    }
    body.cutter->begin(*blade.pose());
}

void Simulation::State::endStroke() {
    accept(body.cutter->inStroke() ? body.cutter->finish() : CutResult{});
}

void Simulation::State::accept(const CutResult& result) {
    lastCut = result;
    report.add(result.statistics);
    report.search.add(body.cutter->takeSearchWork());
    addTo(body.subdivisions, result.statistics.patterns);
    for (std::string& sentence : sentencesAbout(result, stepsDone)) {
        messages.push_back(std::move(sentence));
    }
    if (!result.delta.empty()) {
        tellOf(log.noteCut(time));
        adopt(result.delta);
    }
}

void Simulation::State::adopt(const CutDelta& delta) {
    const std::string defect = body.adopt(delta);
    log.history().followCut(body.mesh, delta);
    if (!defect.empty()) {
        say("step {}: the cut left the mesh open: {}", stepsDone, defect);
    }
}

/// Whatever the blade was about to do, it does no more.
void Simulation::State::putBladeAway() {
    blade.forgetActions();
    if (blade.isPlaced()) {
        touch();
        cut(LiftBlade{});
        publish();
    }
}

BladePush Simulation::State::bladePush() const {
    return {{params.bladeWidth * body.diagonal, params.bladeThickness * body.diagonal},
            body.wallEdge,
            contactSettings(params).substeps};
}

std::optional<BladeMotion> Simulation::State::bladeBody() const {
    return params.bladePush != 0 ? blade.body(bladePush()) : std::nullopt;
}

/// In the coming step.
std::optional<BladeMotion> Simulation::State::bladeMotion() const {
    const bool pushes = params.bladePush != 0 && blade.isPlaced();
    return pushes ? blade.motion(bladePush(), body.front()) : std::nullopt;
}

}  // namespace kerf

// Taking changes back and bringing them back, and going to other moments.
#include "sim/run/simulation_state.h"

namespace kerf {

std::string Simulation::State::undo() {
    putBladeAway();
    UndoHistory& history = log.history();
    if (!history.canUndo()) {
        return "There is nothing to undo.";
    }
    SnapshotPointer after;
    const UndoEntry& entry = history.lastDone();
    if (std::holds_alternative<UndoEntry::BodySnapshotChange>(entry.change)) {
        after = capture();
    }
    std::visit([this](const auto& change) { apply(change, false); }, entry.change);
    history.markUndone(std::move(after));
    return "";
}

std::string Simulation::State::redo() {
    UndoHistory& history = log.history();
    if (history.canRedo()) {
        putBladeAway();  // the end of a stroke may be a change, after which nothing is undone
    }
    if (!history.canRedo()) {
        return "There is nothing to redo.";
    }
    std::visit([this](const auto& change) { apply(change, true); }, history.firstUndone().change);
    history.markRedone();
    return "";
}

void Simulation::State::apply(const UndoEntry::ParamChange& change, bool forward) {
    touch();
    setParam(params, change.param, forward ? change.after : change.before);
    paramsChanged = true;
}

void Simulation::State::apply(const UndoEntry::PinChange& change, bool forward) {
    touch();
    body.pins = forward ? change.after : change.before;
    body.solver.masses().setPinned(body.pins.vertices());
}

void Simulation::State::apply(const UndoEntry::BodySnapshotChange& change, bool forward) {
    restoreBody(forward ? change.after : change.before);
}

void Simulation::State::apply(const UndoEntry::BoxesChange& change, bool forward) {
    setBoxes(forward ? change.after : change.before);
}

SnapshotPointer Simulation::State::capture() {
    body.mesh.bringAll();
    if (!current) {
        current = body.capture();
    }
    return current;
}

/// Null where nothing is kept, or where a snapshot would not fit: a large body is not copied for
/// nothing.
SnapshotPointer Simulation::State::captureForUndo() {
    const UndoHistory& history = log.history();
    const bool fits = history.keeps() && snapshotBytes(body.mesh) <= history.budget();
    return fits ? capture() : nullptr;
}

void Simulation::State::tellOf(UndoLog::Noted noted) {
    if (noted == UndoLog::Noted::kept) {
        toldTooLarge = false;
    } else if (noted == UndoLog::Noted::tooLarge && !std::exchange(toldTooLarge, true)) {
        say("step {}: the body is larger than the undo memory ({} MB), so what has changed it so "
            "far can't be undone",
            stepsDone, log.history().budget() >> 20);
    }
}

void Simulation::State::restoreBody(const SnapshotPointer& snapshot) {
    body.restore(*snapshot);
    blade = {};
    lastCut = {};
    paramsChanged = true;  // the cutter follows some of them
    current = snapshot;
    publish();
}

Moment Simulation::State::moment() {
    return Moment(std::make_shared<const Moment::Content>(
        Moment::Content{capture(), params, boxes, blade, log, stepsDone, time, report}));
}

void Simulation::State::goTo(const Moment::Content& then) {
    restoreBody(then.body);
    params = then.params;
    setBoxes(then.boxes);
    blade = then.blade;
    blade.forgetActions();
    log = then.log;
    stepsDone = then.stepsDone;
    time = then.time;
    report = then.report;
}

}  // namespace kerf

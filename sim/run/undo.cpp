// Taking changes back and bringing them back, and going to checkpoints.
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
        after = log.capture(body);
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
    log.touch();
    setParam(input.params, change.param, forward ? change.after : change.before);
    noteParamsChanged();
}

void Simulation::State::apply(const UndoEntry::MaterialChange& change, bool forward) {
    for (const UndoEntry::ParamChange& param : change.params) {
        apply(param, forward);
    }
}

void Simulation::State::apply(const UndoEntry::PinChange& change, bool forward) {
    log.touch();
    body.setPins(forward ? change.after : change.before);
}

void Simulation::State::apply(const UndoEntry::BodySnapshotChange& change, bool forward) {
    for (const UndoEntry::ParamChange& param : change.params) {
        apply(param, forward);
    }
    restoreBody(forward ? change.after : change.before);
}

void Simulation::State::apply(const UndoEntry::BoxesChange& change, bool forward) {
    setBoxes(forward ? change.after : change.before);
}

void Simulation::State::restoreBody(const SnapshotPointer& snapshot) {
    body.restore(*snapshot);
    input.blade = {};
    input.paramsChanged = true;  // the cutter follows some of them
    output.lastCut = {};
    log.isAt(snapshot);
    publish();
}

Checkpoint Simulation::State::checkpoint() {
    return Checkpoint(std::make_shared<const Checkpoint::Content>(
        Checkpoint::Content{log.capture(body), input, log, output.clock, output.report}));
}

void Simulation::State::goTo(const Checkpoint::Content& then) {
    restoreBody(then.body);
    input = then.input;
    input.paramsChanged = true;
    setBoxes(then.input.boxes);
    log = then.log;
    output.clock = then.clock;
    output.report = then.report;
}

}  // namespace kerf

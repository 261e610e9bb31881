// How each kind of command is carried out.
#include "sim/base/boxes.h"
#include "sim/base/size_params.h"
#include "sim/run/simulation_state.h"

namespace kerf {

namespace {

/// Of the parameters that follow a size.
std::vector<UndoEntry::ParamChange> changesOfSize(const Params& before, const Params& after) {
    std::vector<UndoEntry::ParamChange> changes;
    for (const char* name : {"time_step", "depenetration_speed"}) {
        const ParamValue from = getParam(before, name);
        const ParamValue to = getParam(after, name);
        if (from != to) {
            changes.push_back({name, from, to});
        }
    }
    return changes;
}

}  // namespace

template <>
std::string Simulation::State::carryOut(const MoveBlade& move) {
    std::string error = checkBlade(move.blade);
    if (error.empty()) {
        input.blade.tell(move);
    }
    return error;
}

template <>
std::string Simulation::State::carryOut(const LiftBlade& lift) {
    input.blade.tell(lift);
    return "";
}

template <>
std::string Simulation::State::carryOut(const SetParam& set) {
    const ParamValue before = getParam(input.params, set.name);
    if (std::string error = setParam(input.params, set.name, set.value); !error.empty()) {
        return error;
    }
    const ParamValue after = getParam(input.params, set.name);
    if (after != before) {
        log.touch();
        noteParamsChanged();
        log.noteParam(set.name, before, after, set.continues, output.clock.time);
    }
    return "";
}

template <>
std::string Simulation::State::carryOut(const Grab& grab) {
    const SnapshotPointer before = log.captureForUndo(body);
    log.touch();
    std::string error = body.memory.hands.grab(grab, body.mesh);
    if (error.empty()) {
        log.noteBody("Pull", before, output);
    }
    return error;
}

template <>
std::string Simulation::State::carryOut(const Drag& drag) {
    log.touch();
    return body.memory.hands.drag(drag);
}

template <>
std::string Simulation::State::carryOut(const Release& release) {
    log.touch();
    return body.memory.hands.release(release);
}

template <>
std::string Simulation::State::carryOut(const Pin& pin) {
    log.touch();
    Pins before = body.memory.pins;
    if (body.memory.pins.change(pin.region, pin.pinned, body.mesh) == 0) {
        return pin.pinned ? "No free vertex lies in that region; nothing was pinned."
                          : "No pinned vertex lies in that region; nothing was freed.";
    }
    body.solver.masses().setPinned(body.memory.pins.vertices());
    log.notePins(std::move(before), body.memory.pins, pin, output.clock.time);
    return "";
}

template <>
std::string Simulation::State::carryOut(const AddBox& add) {
    return apply(edited(input.boxes, add));
}

template <>
std::string Simulation::State::carryOut(const ChangeBox& change) {
    return apply(edited(input.boxes, change));
}

template <>
std::string Simulation::State::carryOut(const RemoveBox& remove) {
    return apply(edited(input.boxes, remove));
}

std::string Simulation::State::apply(BoxEdit edit) {
    if (!edit.error.empty() || edit.after == input.boxes) {
        return edit.error;
    }
    log.noteBoxes(input.boxes, edit, output.clock.time);
    setBoxes(std::move(edit.after));
    return "";
}

void Simulation::State::setBoxes(std::vector<StaticBox> now) {
    input.boxes = std::move(now);
    body.solver.collisions().setBoxes(input.boxes);
}

/// Whatever the blade was about to do, it does no more.
void Simulation::State::putBladeAway() {
    input.blade.forgetActions();
    if (input.blade.isPlaced()) {
        log.touch();
        stroke.lift();
        publish();
    }
}

template <>
std::string Simulation::State::carryOut(const Restart&) {
    putBladeAway();
    log.noteBody("Restart", log.captureForUndo(body), output);
    startBody();
    return "";
}

template <>
std::string Simulation::State::carryOut(const Place& place) {
    SurfaceMesh placed = body.placedMesh(place.placement);
    const Bounds bounds = boxOf(placed.restPositions());
    if (const std::string problem = checkRoom(bounds); !problem.empty()) {
        return "T" + problem.substr(1);
    }
    putBladeAway();
    const bool continues = log.continuesPlacement(place);
    const Params before = input.params;
    input.params = followSize(body.diagonal, bounds.diagonal(), before);
    log.notePlacement(place, continues ? nullptr : log.captureForUndo(body),
                      changesOfSize(before, input.params), output);
    body.startAnew(std::move(placed), place.placement);
    beginAtRest();
    return "";
}

template <>
std::string Simulation::State::carryOut(const Undo&) {
    return undo();
}

template <>
std::string Simulation::State::carryOut(const Redo&) {
    return redo();
}

template <>
std::string Simulation::State::carryOut(const SetTime& set) {
    input.timeRuns = set.runs;
    return "";
}

std::string Simulation::State::execute(const Command& command) {
    body.memory.recovery.allowAgain();
    return std::visit([this](const auto& kind) { return carryOut(kind); }, command);
}

}  // namespace kerf

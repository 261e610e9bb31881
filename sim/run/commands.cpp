// How each kind of command is carried out.
#include "sim/run/simulation_state.h"

namespace kerf {

template <>
std::string Simulation::State::carryOut(const MoveBlade& move) {
    std::string error = checkBlade(move.blade);
    if (error.empty()) {
        blade.tell(move);
    }
    return error;
}

template <>
std::string Simulation::State::carryOut(const LiftBlade& lift) {
    blade.tell(lift);
    return "";
}

template <>
std::string Simulation::State::carryOut(const SetParam& set) {
    const ParamValue before = getParam(params, set.name);
    if (std::string error = setParam(params, set.name, set.value); !error.empty()) {
        return error;
    }
    const ParamValue after = getParam(params, set.name);
    if (after != before) {
        touch();
        paramsChanged = true;
        log.noteParam(set.name, before, after, set.continues, time);
    }
    return "";
}

template <>
std::string Simulation::State::carryOut(const Grab& grab) {
    const SnapshotPointer before = captureForUndo();
    touch();
    std::string error = body.hands.grab(grab, body.mesh);
    if (error.empty()) {
        tellOf(log.noteBody("Pull", before, time));
    }
    return error;
}

template <>
std::string Simulation::State::carryOut(const Drag& drag) {
    touch();
    return body.hands.drag(drag);
}

template <>
std::string Simulation::State::carryOut(const Release& release) {
    touch();
    return body.hands.release(release);
}

template <>
std::string Simulation::State::carryOut(const Pin& pin) {
    touch();
    Pins before = body.pins;
    if (body.pins.change(pin.region, pin.pinned, body.mesh) == 0) {
        return pin.pinned ? "No free vertex lies in that region; nothing was pinned."
                          : "No pinned vertex lies in that region; nothing was freed.";
    }
    body.solver.masses().setPinned(body.pins.vertices());
    log.notePins(std::move(before), body.pins, pin, time);
    return "";
}

template <>
std::string Simulation::State::carryOut(const AddBox& add) {
    return apply(edited(boxes, add));
}

template <>
std::string Simulation::State::carryOut(const ChangeBox& change) {
    return apply(edited(boxes, change));
}

template <>
std::string Simulation::State::carryOut(const RemoveBox& remove) {
    return apply(edited(boxes, remove));
}

std::string Simulation::State::apply(BoxEdit edit) {
    if (!edit.error.empty() || edit.after == boxes) {
        return edit.error;
    }
    log.noteBoxes(boxes, edit, time);
    setBoxes(std::move(edit.after));
    return "";
}

void Simulation::State::setBoxes(std::vector<StaticBox> now) {
    boxes = std::move(now);
    body.solver.collisions().setBoxes(boxes);
}

template <>
std::string Simulation::State::carryOut(const Restart&) {
    putBladeAway();
    tellOf(log.noteBody("Restart", captureForUndo(), time));
    startBody();
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

std::string Simulation::State::execute(const Command& command) {
    return std::visit([this](const auto& kind) { return carryOut(kind); }, command);
}

}  // namespace kerf

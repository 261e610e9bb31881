// Commands that take effect at once.
#include "sim/run/simulation_state.h"

namespace kerf {

std::string Simulation::State::execute(const MoveBlade& move) {
    std::string error = checkBlade(move.blade);
    if (error.empty()) {
        blade.tell(move);
    }
    return error;
}

std::string Simulation::State::execute(const LiftBlade& lift) {
    blade.tell(lift);
    return "";
}

std::string Simulation::State::execute(const SetParam& set) {
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

std::string Simulation::State::execute(const Grab& grab) {
    const SnapshotPointer before = captureForUndo();
    touch();
    std::string error = body.hands.grab(grab, body.mesh);
    if (error.empty()) {
        tellOf(log.noteBody("Pull", before, time));
    }
    return error;
}

std::string Simulation::State::execute(const Drag& drag) {
    touch();
    return body.hands.drag(drag);
}

std::string Simulation::State::execute(const Release& release) {
    touch();
    return body.hands.release(release);
}

std::string Simulation::State::execute(const Pin& pin) {
    touch();
    Pins before = body.pins;
    if (body.pins.change(pin.region, pin.pinned, body.mesh) == 0) {
        return pin.pinned ? "No free vertex lies in that region; nothing was pinned."
                          : "No pinned vertex lies in that region; nothing was freed.";
    }
    body.solver.setPinned(body.pins.vertices());
    log.notePins(std::move(before), body.pins, pin, time);
    return "";
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
    body.solver.setBoxes(boxes);
}

std::string Simulation::State::execute(const Restart&) {
    putBladeAway();
    tellOf(log.noteBody("Restart", captureForUndo(), time));
    startBody();
    return "";
}

}  // namespace kerf

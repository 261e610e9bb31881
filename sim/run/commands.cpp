// How each kind of command is carried out.

#include <spdlog/fmt/fmt.h>

#include "sim/base/math.h"
#include "sim/base/size_params.h"
#include "sim/run/blade/cut_followers.h"
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

/// Whether all of it has coordinates that a scene may have.
bool isNear(const Bounds& bounds) {
    constexpr double kFarthest = 1e6;  // [m]
    return bounds.low.allFinite() && bounds.high.allFinite() &&
           bounds.low.minCoeff() >= -kFarthest && bounds.high.maxCoeff() <= kFarthest;
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
    if (std::string problem = body.checkModel(modelOf(set.name)); !problem.empty()) {
        return problem;
    }
    const ParamValue before = getParam(input.params, set.name);
    if (std::string error = setParam(input.params, set.name, set.value); !error.empty()) {
        return error;
    }
    const ParamValue after = getParam(input.params, set.name);
    if (after != before) {
        log.touch();
        noteParamsChanged();
        if (set.material.empty()) {
            log.noteParam(set.name, before, after, set.continues, output.clock.time);
        } else {
            log.noteMaterial(set.material, {set.name, before, after}, output.clock.time);
        }
    }
    return "";
}

template <>
std::string Simulation::State::carryOut(const Grab& grab) {
    const bool continues = grab.continues && log.continuesBody(BodyGesture::hands);
    const SnapshotPointer before = continues ? nullptr : log.captureForUndo(body);
    const auto& hands = body.memory.hands.hands();
    const bool again = std::ranges::count(hands, grab.hand, &Hands::Hand::number) > 0;
    log.touch();
    std::string error = body.memory.hands.grab(grab, body.mesh());
    if (error.empty() && continues) {
        log.history().renameLast("Hold open");
    } else if (error.empty()) {
        log.noteBody(again ? "Let go" : "Pull", before, output, BodyGesture::hands);
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
    if (!pin.velocity.value_or(Vec3::Zero()).allFinite() || !(pin.seconds.value_or(1) > 0)) {
        return "A motion needs a finite velocity, and a time above 0.";
    }
    Pins after = body.memory.pins;
    if (after.change(pin, body.mesh()) == 0) {
        return pin.pinned ? "No free vertex lies in that region; nothing was pinned."
                          : "No pinned vertex lies in that region; nothing was freed.";
    }
    const std::string name = pin.velocity ? "Move: " + textOf(*pin.velocity) + " m/s"
                                          : (pin.pinned ? "Pin" : "Free pins");
    changePins(name, std::move(after), pin.continues);
    return "";
}

template <>
std::string Simulation::State::carryOut(const ApplyForce& apply) {
    if (!apply.newtons.allFinite()) {
        return "A force needs finite newtons.";
    }
    log.touch();
    Pins after = body.memory.pins;
    const bool frees = apply.newtons == Vec3::Zero();
    if (after.change(apply, body.mesh()) == 0) {
        return frees ? "No force acts in that region; nothing was changed."
                     : "No vertex without this force lies in that region; nothing was changed.";
    }
    const std::string name = frees ? "Remove force" : "Force: " + textOf(apply.newtons) + " N";
    changePins(name, std::move(after), apply.continues);
    return "";
}

void Simulation::State::changePins(const std::string& name, Pins after, bool continues) {
    log.notePins(name, body.memory.pins, after, continues, output.clock.time);
    body.memory.pins = std::move(after);
    body.holdPins();
}

template <>
std::string Simulation::State::carryOut(const MovePins& move) {
    if (body.memory.pins.vertices().empty()) {
        return "Nothing is pinned that could be moved.";
    }
    if (!isNear(body.pinnedAfter(move))) {
        return "What is pinned would leave the range of 1e6 m; move it less far.";
    }
    if (!(move.continues && log.continuesBody(BodyGesture::pins))) {
        log.noteBody("Move pins", log.captureForUndo(body), output, BodyGesture::pins);
    }
    log.touch();
    body.movePinned(move);
    publish();
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

template <>
std::string Simulation::State::carryOut(const RemovePiece& remove) {
    const std::vector<int>& pieces = body.model().pieceOfVertex;
    const auto vertex = std::ranges::find(pieces, std::max(remove.piece, 0));
    const std::size_t count = body.model().pieces.size();
    if (remove.piece < 0 || vertex == pieces.end()) {
        return fmt::format("There is no piece {}; they count from 0 to {}.", remove.piece,
                           count - 1);
    }
    if (count == 1 || input.blade.isPlaced()) {
        return count == 1 ? "This is the only piece; a scene keeps one."
                          : "A stroke is under way; end it before you remove a piece.";
    }
    const int at = static_cast<int>(vertex - pieces.begin());
    log.noteBody("Delete piece " + std::to_string(remove.piece + 1), log.captureForUndo(body),
                 output, BodyGesture::none, remove.piece);
    log.touch();
    endTear(body, log.history(), output);
    body.mesh().bringAll();
    followCut(body.cutter->removePieceAt(at), body, log.history(), output);
    body.memory.hands.forgetDead(body.mesh());
    body.memory.guard.startAnew();
    body.holdPins();
    body.measureAtRest();
    publish();
    return "";
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

/// The uncut body with these models, where there is one: as at first, or prepared ahead.
std::shared_ptr<const UncutBody> Simulation::State::preparedAs(
    const std::vector<PlacedModel>& models) {
    std::shared_ptr<const UncutBody> prepared = std::exchange(preparedPlacement, nullptr);
    if (models == body.first->models) {
        return body.first;
    }
    return prepared && prepared->models == models ? prepared : nullptr;
}

template <>
std::string Simulation::State::carryOut(const Place& place) {
    if (std::string problem = body.checkModel(place.model); !problem.empty()) {
        return problem;
    }
    std::vector<PlacedModel> models = body.uncut->models;
    models[place.model].placement = place.placement;
    std::shared_ptr<const UncutBody> placed = preparedAs(models);
    SurfaceMesh mesh = placed ? SurfaceMesh() : placedMesh(*body.first, models);
    const std::vector<Vec3>& rest = placed ? placed->mesh.restPositions() : mesh.restPositions();
    if (const std::string problem = checkRoom(boxOf(rest)); !problem.empty()) {
        return "T" + problem.substr(1);
    }
    putBladeAway();
    const bool continues = place.continues && log.continuesBody(BodyGesture::placement);
    const Params before = input.params;
    input.params = followSize(body.uncut->sizeOfModels(), sizeOfModels(rest, models), before);
    log.notePlacement(place, continues ? nullptr : log.captureForUndo(body),
                      changesOfSize(before, input.params), output);
    if (placed == nullptr) {
        placed = makeUncutBody(std::move(mesh), std::move(models));
    }
    body.startAnew(std::move(placed));
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
    body.memory.stillFor = 0;
    return std::visit([this](const auto& kind) { return carryOut(kind); }, command);
}

}  // namespace kerf

#include "sim/run/undo/undo_log.h"

namespace kerf {

namespace {

/// Each parameter stands there once, with its first value and its last one.
void join(std::vector<UndoEntry::ParamChange>& changes, UndoEntry::ParamChange later) {
    const auto earlier = std::ranges::find(changes, later.param, &UndoEntry::ParamChange::param);
    if (earlier == changes.end()) {
        changes.push_back(std::move(later));
    } else {
        earlier->after = later.after;
    }
}

}  // namespace

void UndoLog::clear() {
    history_.clear();
    cutsSoFar_ = 0;
    endStroke();
}

SnapshotPointer UndoLog::capture(RunningBody& body) {
    body.mesh().bringAll();
    if (!current_) {
        current_ = body.capture();
    }
    return current_;
}

SnapshotPointer UndoLog::captureForUndo(RunningBody& body) {
    const bool fits = history_.keeps() && snapshotBytes(body.mesh()) <= history_.budget();
    return fits ? capture(body) : nullptr;
}

void UndoLog::noteParam(const std::string& param, const ParamValue& before, const ParamValue& after,
                        bool continues, double time) {
    std::string name = nameOfChange(param, after);
    auto* last = history_.continued<UndoEntry::ParamChange>();
    if (continues && last != nullptr && last->param == param) {
        last->after = after;
        history_.renameLast(std::move(name));
    } else {
        history_.add({std::move(name), time, UndoEntry::ParamChange{param, before, after}});
    }
}

void UndoLog::noteMaterial(const std::string& material, UndoEntry::ParamChange change,
                           double time) {
    auto* last = history_.continued<UndoEntry::MaterialChange>();
    if (last == nullptr || last->material != material) {
        history_.add({"Material: " + material, time,
                      UndoEntry::MaterialChange{material, {std::move(change)}}});
    } else {
        join(last->params, std::move(change));
    }
}

void UndoLog::notePins(const std::string& name, Pins before, Pins after, bool continues,
                       double time) {
    auto* last = history_.continued<UndoEntry::PinChange>();
    if (continues && last != nullptr) {
        last->after = std::move(after);
    } else {
        history_.add({name, time, UndoEntry::PinChange{std::move(before), std::move(after)}});
    }
}

void UndoLog::noteBoxes(std::vector<StaticBox> before, const BoxEdit& edit, double time) {
    auto* last = history_.continued<UndoEntry::BoxesChange>();
    if (edit.continues && last != nullptr && last->changed == edit.changed) {
        last->after = edit.after;
    } else {
        history_.add(
            {edit.name, time, UndoEntry::BoxesChange{std::move(before), edit.after, edit.changed}});
    }
}

void UndoLog::noteBody(std::string name, SnapshotPointer before, SimulationOutput& output,
                       BodyGesture gesture, int removedPiece) {
    if (before) {
        history_.add(
            {std::move(name), output.clock.time,
             UndoEntry::BodySnapshotChange{std::move(before), nullptr, gesture, {}, removedPiece}});
        output.toldTooLarge = false;
    } else if (history_.keeps()) {
        history_.forgetAll();
        if (!std::exchange(output.toldTooLarge, true)) {
            output.say(
                "the body is larger than the undo memory ({} MB), so what has changed it so far "
                "can't be undone",
                history_.budget() >> 20);
        }
    }
}

bool UndoLog::continuesBody(BodyGesture gesture) {
    const auto* last = history_.continued<UndoEntry::BodySnapshotChange>();
    return last != nullptr && last->gesture == gesture;
}

void UndoLog::notePlacement(const Place& place, SnapshotPointer before,
                            std::vector<UndoEntry::ParamChange> params, SimulationOutput& output) {
    if (!place.continues || !continuesBody(BodyGesture::placement)) {
        const bool kept = before != nullptr;
        noteBody("Placement", std::move(before), output, BodyGesture::placement);
        if (kept) {
            auto* entry = history_.continued<UndoEntry::BodySnapshotChange>();
            entry->params = std::move(params);
        }
        return;
    }
    auto* entry = history_.continued<UndoEntry::BodySnapshotChange>();
    for (UndoEntry::ParamChange& change : params) {
        join(entry->params, std::move(change));
    }
}

void UndoLog::beginStroke(RunningBody& body) {
    if (!strokeNoted_ && !beforeStroke_) {
        beforeStroke_ = captureForUndo(body);
    }
}

void UndoLog::noteCut(SimulationOutput& output) {
    if (!history_.keeps() || strokeNoted_) {
        return;
    }
    strokeNoted_ = true;
    ++cutsSoFar_;
    noteBody("Cut " + std::to_string(cutsSoFar_), std::exchange(beforeStroke_, nullptr), output);
}

void UndoLog::endStroke() {
    beforeStroke_.reset();
    strokeNoted_ = false;
}

}  // namespace kerf

#include "sim/run/undo_log.h"

#include <utility>

namespace kerf {

void UndoLog::clear() {
    history_.clear();
    cutsSoFar_ = 0;
    endStroke();
}

void UndoLog::noteParam(const std::string& param, const ParamValue& before, const ParamValue& after,
                        bool continues, double time) {
    std::string name = nameOfChange(*findParam(param), after);
    auto* last = history_.continued<UndoEntry::ParamChange>();
    if (continues && last != nullptr && last->param == param) {
        last->after = after;
        history_.renameLast(std::move(name));
    } else {
        history_.add({std::move(name), time, UndoEntry::ParamChange{param, before, after}});
    }
}

void UndoLog::notePins(Pins before, Pins after, const Pin& pin, double time) {
    auto* last = history_.continued<UndoEntry::PinChange>();
    if (pin.continues && last != nullptr) {
        last->after = std::move(after);
    } else {
        history_.add({pin.pinned ? "Pin" : "Free pins", time,
                      UndoEntry::PinChange{std::move(before), std::move(after)}});
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

UndoLog::Noted UndoLog::noteBody(std::string name, SnapshotPointer before, double time) {
    if (before) {
        history_.add(
            {std::move(name), time, UndoEntry::BodySnapshotChange{std::move(before), nullptr}});
        return Noted::kept;
    }
    if (!history_.keeps()) {
        return Noted::nothing;
    }
    history_.forgetAll();
    return Noted::tooLarge;
}

UndoLog::Noted UndoLog::noteCut(double time) {
    if (!history_.keeps() || strokeNoted_) {
        return Noted::nothing;
    }
    strokeNoted_ = true;
    ++cutsSoFar_;
    return noteBody("Cut " + std::to_string(cutsSoFar_), std::exchange(beforeStroke_, nullptr),
                    time);
}

void UndoLog::endStroke() {
    beforeStroke_.reset();
    strokeNoted_ = false;
}

}  // namespace kerf

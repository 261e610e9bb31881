#include "app/session_journal.h"

#include <algorithm>

namespace kerf::app {
namespace {

SessionAction actionOf(const Command& command) {
    return std::visit([](const auto& c) { return SessionAction(c); }, command);
}

/// The value of a slider that is dragged while time stands: only the last one counts.
bool replaces(const SetParam& later, const SessionEvent& before, int step) {
    const auto* set = std::get_if<SetParam>(&before.action);
    return set != nullptr && later.continues && before.step == step && set->name == later.name;
}

}  // namespace

void SessionJournal::note(int step, const Command& command) {
    const auto* set = std::get_if<SetParam>(&command);
    if (set != nullptr && !events_.empty() && replaces(*set, events_.back(), step)) {
        std::get<SetParam>(events_.back().action).value = set->value;
        return;
    }
    if (std::holds_alternative<MoveBlade>(command)) {
        holdBlade(step);
        lastPose_ = SessionEvent{step, actionOf(command)};
    } else if (takesBladeAway(actionOf(command))) {
        lastPose_.reset();
    }
    events_.push_back({step, actionOf(command)});
}

/// In a session the blade moves from each pose to the next. Where it stood still until the step
/// before, that must be said.
void SessionJournal::holdBlade(int step) {
    if (!lastPose_ || lastPose_->step >= step - 1) {
        return;
    }
    const auto later = [](int value, const SessionEvent& event) { return value < event.step; };
    events_.insert(std::upper_bound(events_.begin(), events_.end(), step - 1, later),
                   {step - 1, lastPose_->action});
}

void SessionJournal::goBackTo(const Mark& mark) {
    events_.resize(std::min(mark.events, events_.size()));
    lastPose_ = mark.lastPose;
}

}  // namespace kerf::app

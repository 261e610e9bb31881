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
    notePose(step, command);
    noteHand(step, command);
    events_.push_back({step, actionOf(command)});
}

void SessionJournal::notePose(int step, const Command& command) {
    if (std::holds_alternative<MoveBlade>(command)) {
        if (lastPose_) {
            hold(*lastPose_, step);
        }
        lastPose_ = SessionEvent{step, actionOf(command)};
    } else if (takesBladeAway(actionOf(command))) {
        lastPose_.reset();
    }
}

void SessionJournal::noteHand(int step, const Command& command) {
    if (const auto* grab = std::get_if<Grab>(&command)) {
        lastDrags_[grab->hand] = {step, Drag{grab->hand, grab->at}};
    } else if (const auto* drag = std::get_if<Drag>(&command)) {
        if (const auto last = lastDrags_.find(drag->hand); last != lastDrags_.end()) {
            hold(last->second, step);
        }
        lastDrags_[drag->hand] = {step, *drag};
    } else if (const auto* release = std::get_if<Release>(&command)) {
        lastDrags_.erase(release->hand);
    } else if (std::holds_alternative<Restart>(command)) {
        lastDrags_.clear();
    }
}

/// In a session blade and hands move from each pose to the next. Where one stood still until the
/// step before, that must be said.
void SessionJournal::hold(const SessionEvent& last, int step) {
    if (last.step >= step - 1) {
        return;
    }
    const auto later = [](int value, const SessionEvent& event) { return value < event.step; };
    events_.insert(std::upper_bound(events_.begin(), events_.end(), step - 1, later),
                   {step - 1, last.action});
}

void SessionJournal::goBackTo(const Mark& mark) {
    events_.resize(std::min(mark.events, events_.size()));
    lastPose_ = mark.lastPose;
    lastDrags_ = mark.lastDrags;
}

}  // namespace kerf::app

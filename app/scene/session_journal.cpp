#include "app/scene/session_journal.h"

#include <algorithm>

namespace kerf::app {
namespace {

SessionAction actionOf(const Command& command) {
    return std::visit([](const auto& c) { return SessionAction(c); }, command);
}

/// What a slider changes that is dragged while time stands: only its last value counts. Returns
/// whether `before` was changed instead of noting a later event.
bool extend(SessionEvent& before, const Command& command) {
    if (const auto* later = std::get_if<SetParam>(&command); later != nullptr && later->continues) {
        auto* set = std::get_if<SetParam>(&before.action);
        if (set != nullptr && set->name == later->name) {
            set->value = later->value;
            return true;
        }
    }
    if (const auto* later = std::get_if<ChangeBox>(&command); later && later->continues) {
        auto* change = std::get_if<ChangeBox>(&before.action);
        if (change != nullptr && change->index == later->index) {
            change->box = later->box;
            return true;
        }
    }
    return false;
}

}  // namespace

void SessionJournal::note(int step, const Command& command) {
    if (!events_.empty() && events_.back().step == step && extend(events_.back(), command)) {
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

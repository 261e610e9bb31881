#include "app/scene/timeline/event_log.h"

namespace kerf::app {
namespace {

using Origin = LogEntry::Origin;

SessionAction actionOf(const Command& command) {
    return std::visit([](const auto& c) { return SessionAction(c); }, command);
}

bool isCommand(const LogEntry& entry) {
    return commandOf(entry.event.action).has_value();
}

bool isChange(const LogEntry& entry) {
    return entry.origin == Origin::person && isCommand(entry);
}

/// Whether both give a value to the same thing: of what is dragged, the last one counts.
bool setTheSame(const SessionAction& earlier, const Command& later) {
    if (const auto* set = std::get_if<SetParam>(&later)) {
        const auto* before = std::get_if<SetParam>(&earlier);
        return before != nullptr && before->name == set->name;
    }
    if (const auto* change = std::get_if<ChangeBox>(&later)) {
        const auto* before = std::get_if<ChangeBox>(&earlier);
        return before != nullptr && before->index == change->index;
    }
    const auto* place = std::get_if<Place>(&later);
    const auto* before = std::get_if<Place>(&earlier);
    return place != nullptr && before != nullptr && place->model == before->model;
}

bool continuesGesture(const Command& command) {
    const auto* set = std::get_if<SetParam>(&command);
    const auto* change = std::get_if<ChangeBox>(&command);
    const auto* place = std::get_if<Place>(&command);
    return (set != nullptr && set->continues) || (change != nullptr && change->continues) ||
           (place != nullptr && place->continues);
}

/// Gives the value of `later` to what set the same thing.
void takeValue(SessionAction& earlier, const Command& later) {
    if (const auto* set = std::get_if<SetParam>(&later)) {
        std::get<SetParam>(earlier).value = set->value;
    } else if (const auto* change = std::get_if<ChangeBox>(&later)) {
        std::get<ChangeBox>(earlier).box = change->box;
    } else {
        std::get<Place>(earlier).placement = std::get<Place>(later).placement;
    }
}

}  // namespace

// --- What a person does ------------------------------------------------------------------------

void EventLog::note(int step, const Command& command) {
    noteChangeAt(step);
    if (!mergeIntoLast(step, command)) {
        notePose(step, command);
        noteHand(step, command);
        noted_ = insert(done_, Origin::person, {step, actionOf(command)}).id;
    }
    voidLater(command);
    doubtChecksFrom(done_);
}

/// From the first change on, what could not be carried out is saved no more.
void EventLog::noteChangeAt(int step) {
    ++deeds_;
    if (!firstChange_ && std::ranges::any_of(entries_, &LogEntry::failed)) {
        touch(0);
    }
    firstChange_ = std::min(step, firstChange_.value_or(step));
}

void EventLog::touch(const LogEntry& entry) {
    const auto index = static_cast<std::size_t>(&entry - entries_.data());
    touch(index);
}

void EventLog::note(int step, CheckEvent check) {
    insert(done_, Origin::editor, {step, std::move(check)});
}

void EventLog::clear() {
    const int id = lastId_;
    const int revision = revision_;
    const int deeds = deeds_;
    *this = EventLog{};
    lastId_ = id;
    revision_ = revision + 1;
    deeds_ = deeds;
    touch(0);
}

/// What a slider changes that is dragged while time stands: only its last value counts.
bool EventLog::mergeIntoLast(int step, const Command& command) {
    if (done_ == 0 || !continuesGesture(command)) {
        return false;
    }
    LogEntry& last = entries_[done_ - 1];
    const bool merges =
        last.id == noted_ && last.event.step == step && setTheSame(last.event.action, command);
    if (merges) {
        takeValue(last.event.action, command);
        touch(last);
    }
    return merges;
}

/// A slider stays where it was moved to last, whenever in the session that was.
void EventLog::voidLater(const Command& command) {
    const auto isVoid = [&](const LogEntry& entry) {
        return isChange(entry) && setTheSame(entry.event.action, command);
    };
    const auto rest = std::remove_if(entries_.begin() + static_cast<std::ptrdiff_t>(done_),
                                     entries_.end(), isVoid);
    if (rest != entries_.end()) {
        entries_.erase(rest, entries_.end());
        touch(done_);
    }
}

void EventLog::doubtChecksFrom(std::size_t index) {
    for (; index < entries_.size(); ++index) {
        LogEntry& entry = entries_[index];
        if (std::holds_alternative<CheckEvent>(entry.event.action)) {
            entry.doubtful = true;
            entry.found.reset();
            touch(entry);
        }
    }
}

void EventLog::notePose(int step, const Command& command) {
    if (const auto* move = std::get_if<MoveBlade>(&command)) {
        if (lastPose_) {
            hold(*lastPose_, step);
        }
        lastPose_ = SessionEvent{step, MoveBlade{move->blade}};
    } else if (takesBladeAway(actionOf(command))) {
        lastPose_.reset();
    }
}

void EventLog::noteHand(int step, const Command& command) {
    if (const auto* grab = std::get_if<Grab>(&command)) {
        lastDrags_[grab->hand] = {step, Drag{grab->hand, grab->at}};
    } else if (const auto* drag = std::get_if<Drag>(&command)) {
        if (const auto last = lastDrags_.find(drag->hand); last != lastDrags_.end()) {
            hold(last->second, step);
        }
        lastDrags_[drag->hand] = {step, *drag};
    } else if (const auto* release = std::get_if<Release>(&command)) {
        lastDrags_.erase(release->hand);
    } else if (startsAnew(actionOf(command))) {
        lastDrags_.clear();
    }
}

/// In a session blade and hands move from each pose to the next. Where one stood still until the
/// step before, that must be said.
void EventLog::hold(const SessionEvent& last, int step) {
    if (last.step < step - 1) {
        insert(indexOf({step, 0}), Origin::editor, {step - 1, last.action});
    }
}

// --- A session that is played ------------------------------------------------------------------

void EventLog::open(const std::vector<SessionEvent>& events) {
    clear();
    for (const SessionEvent& event : events) {
        insert(entries_.size(), Origin::session, event);
    }
    done_ = 0;
}

void EventLog::restart() {
    const bool changed = firstChange_.has_value();
    tears_.clear();
    dropTakeOver();
    std::erase_if(entries_, isChange);
    for (LogEntry& entry : entries_) {
        const bool check = std::holds_alternative<CheckEvent>(entry.event.action);
        entry.failed = false;
        entry.found.reset();
        entry.doubtful = check && entry.origin == Origin::person && (changed || entry.doubtful);
    }
    done_ = 0;
    noted_.reset();
    firstChange_.reset();
    lastPose_.reset();
    lastDrags_.clear();
    touch(0);
    ++revision_;
}

void EventLog::dropTakeOver() {
    if (takenOver_) {
        std::erase_if(entries_, [&](const LogEntry& entry) { return entry.id > *takenOver_; });
        std::ranges::move(rest_, std::back_inserter(entries_));
    }
    takenOver_.reset();
    rest_.clear();
}

LogEntry* EventLog::takeDue(int step) {
    noted_.reset();
    const bool due = done_ < entries_.size() && entries_[done_].event.step == step;
    return due ? &entries_[done_++] : nullptr;
}

std::size_t EventLog::commandsDone(int step) const {
    const std::size_t first = std::min(indexOf({step, 0}), done_);
    const auto begin = entries_.begin();
    return static_cast<std::size_t>(std::count_if(begin + static_cast<std::ptrdiff_t>(first),
                                                  begin + static_cast<std::ptrdiff_t>(done_),
                                                  isCommand));
}

void EventLog::goTo(int step, std::size_t commandsDone) {
    noted_.reset();
    done_ = indexOf({step, 0});
    for (std::size_t commands = 0; commands < commandsDone && done_ < entries_.size(); ++done_) {
        commands += isCommand(entries_[done_]) ? 1 : 0;
    }
}

std::size_t EventLog::takeOver(int step, const std::vector<PlayedAction>& cutShort) {
    noteChangeAt(step);
    tears_.erase(tears_.lower_bound(step), tears_.end());
    takenOver_ = takenOver_.value_or(lastId_);
    const std::size_t own = leaveOutRest();
    for (const PlayedAction& pose : cutShort) {
        insert(indexOf({step, 0}), Origin::editor, {step - 1, pose.action});
    }
    ++revision_;
    return own;
}

/// What is to come of the session comes back when it is restarted, with its pictures.
std::size_t EventLog::leaveOutRest() {
    const auto present = entries_.begin() + static_cast<std::ptrdiff_t>(done_);
    const auto own = std::stable_partition(present, entries_.end(), [](const LogEntry& entry) {
        return entry.origin == Origin::session || !isCommand(entry);
    });
    const auto count = static_cast<std::size_t>(std::count_if(own, entries_.end(), isChange));
    rest_.insert(rest_.begin(), std::make_move_iterator(present), std::make_move_iterator(own));
    entries_.erase(present, entries_.end());
    touch(done_);
    return count;
}

std::size_t EventLog::leftOut() const {
    return static_cast<std::size_t>(std::ranges::count(rest_, Origin::session, &LogEntry::origin));
}

void EventLog::noteFailure(LogEntry& entry, bool failed) {
    if (std::exchange(entry.failed, failed) != failed) {
        touch(entry);
    }
}

void EventLog::noteFound(LogEntry& entry, CheckEvent found) {
    entry.found = std::move(found);
    touch(entry);
}

void EventLog::noteTear(int step) {
    revision_ += tears_.insert(step).second ? 1 : 0;
}

// --- Pictures, exports and checks --------------------------------------------------------------

LogPosition EventLog::here(int step) const {
    return {step, done_ == 0 ? 0 : entries_[done_ - 1].id};
}

void EventLog::add(const LogPosition& place, SessionAction action) {
    insert(indexOf(place), Origin::person, {place.step, std::move(action)});
    ++deeds_;
    ++revision_;
}

void EventLog::remove(int id) {
    const auto found = std::ranges::find(entries_, id, &LogEntry::id);
    if (found != entries_.end()) {
        done_ -= static_cast<std::size_t>(found - entries_.begin()) < done_ ? 1 : 0;
        const auto index = static_cast<std::size_t>(found - entries_.begin());
        entries_.erase(found);
        touch(index);
        ++deeds_;
        ++revision_;
    }
}

void EventLog::rename(int id, const std::string& name) {
    const auto found = std::ranges::find(entries_, id, &LogEntry::id);
    if (found != entries_.end() && std::holds_alternative<MarkEvent>(found->event.action)) {
        found->event.action = MarkEvent{name};
        touch(*found);
        ++deeds_;
        ++revision_;
    }
}

/// Before all that is noted for its step, unless it is to stand behind some of that.
std::size_t EventLog::indexOf(const LogPosition& place) const {
    const auto first = std::ranges::lower_bound(
        entries_, place.step, {}, [](const LogEntry& entry) { return entry.event.step; });
    const auto behind = std::ranges::find(entries_, place.behind, &LogEntry::id);
    const auto next = behind == entries_.end() ? first : std::max(first, std::next(behind));
    return static_cast<std::size_t>(next - entries_.begin());
}

LogEntry& EventLog::insert(std::size_t index, Origin origin, SessionEvent event) {
    const auto at = entries_.begin() + static_cast<std::ptrdiff_t>(index);
    const auto entry = entries_.insert(at, {++lastId_, origin, std::move(event), false, false, {}});
    done_ += index <= done_ ? 1 : 0;
    touch(index);
    return *entry;
}

}  // namespace kerf::app

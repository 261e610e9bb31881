#pragma once

#include "app/session/session.h"
#include "sim/run/simulation.h"

namespace kerf::app {

/// An event in a log.
struct LogEntry {
    enum class Origin {
        session,  ///< that is played
        person,
        editor,  ///< of the editor: a check of a recording, or the end of an interrupted move
    };

    int id = 0;  ///< of this entry alone
    Origin origin = Origin::editor;
    SessionEvent event;
    bool failed = false;    ///< a command that failed during playback
    bool doubtful = false;  ///< a check that an earlier change has invalidated
    /// The values that a doubtful check found during playback.
    std::optional<CheckEvent> found;
    bool missed = false;  ///< the end of a stroke that met no body
};

/// A place in a log: before a step, after an entry (its id, 0 for none).
struct LogPosition {
    int step = 0;
    int behind = 0;
};

/// Records all that is done to a simulation since its start, so that it can be saved as a session
/// that replays to the same bits. For a played session it also holds all of its events, and user
/// commands are inserted at the present.
class EventLog {
  public:
    /// Records a user command before step `step`, which never decreases without a played session.
    /// Later user settings of that parameter or box are dropped.
    void note(int step, const Command& command);
    /// Records a check of a recording.
    void note(int step, CheckEvent check);
    void clear();

    // A session that is played.
    /// Restarts with these events, all of them to come.
    void open(const std::vector<SessionEvent>& events);
    /// Restarts it without user commands. Pictures, exports and checks stay.
    void restart();
    /// The next event if due before `step`, which then counts as done; else null.
    LogEntry* takeDue(int step);
    /// The number of commands done so far before the coming step `step`, for goTo().
    std::size_t commandsDone(int step) const;
    /// Sets the present: before `step`, with `commandsDone` of its commands.
    void goTo(int step, std::size_t commandsDone);
    /// The user takes over at `step`: drops what is to come, user commands for good. `cutShort`:
    /// the poses of interrupted moves before the last step. Returns the number of dropped user
    /// events.
    std::size_t takeOver(int step, const std::vector<PlayedAction>& cutShort);

    /// Records that the stroke which the last command ended met no body.
    void noteMiss() { entries_[done_ - 1].missed = true; }
    /// Records the playback of an entry: whether it failed, or what a doubtful check found.
    void noteFailure(LogEntry& entry, bool failed);
    void noteFound(LogEntry& entry, CheckEvent found);

    /// Records that a tear began in step `step`.
    void noteTear(int step);
    /// The steps in which one began, ascending; those that are played again stay.
    const std::set<int>& tears() const { return tears_; }

    // Pictures, exports and checks.
    /// The present, before step `step`.
    LogPosition here(int step) const;
    /// Adds a user action.
    void add(const LogPosition& place, SessionAction action);
    void remove(int id);
    /// Renames a named place.
    void rename(int id, const std::string& name);

    const std::vector<LogEntry>& entries() const { return entries_; }
    /// The first step before which the user changed a played session or took over.
    std::optional<int> firstChange() const { return firstChange_; }
    /// The number of entries at the beginning that are, as saved, as at the last call.
    std::size_t takeUnchanged() { return std::exchange(unchanged_, entries_.size()); }
    /// Whether all are.
    bool isUnchanged() const { return unchanged_ == entries_.size(); }
    /// The number of user actions.
    int deeds() const { return deeds_; }
    /// Events of the session that were to come when the user took over.
    std::size_t leftOut() const;
    /// Step of the last entry; 0 for none.
    int lastStep() const { return entries_.empty() ? 0 : entries_.back().event.step; }
    /// Grows when entries other than commands are added or removed.
    int revision() const { return revision_; }

  private:
    LogEntry& insert(std::size_t index, LogEntry::Origin origin, SessionEvent event);
    std::size_t indexOf(const LogPosition& place) const;
    bool mergeIntoLast(int step, const Command& command);
    void voidLater(const Command& command);
    void doubtChecksFrom(std::size_t index);
    void notePose(int step, const Command& command);
    void noteHand(int step, const Command& command);
    void hold(const SessionEvent& last, int step);
    std::size_t leaveOutRest();
    void dropTakeOver();
    void noteChangeAt(int step);
    void touch(std::size_t index) { unchanged_ = std::min(unchanged_, index); }
    void touch(const LogEntry& entry);

    std::vector<LogEntry> entries_;  ///< by step
    std::size_t done_ = 0;           ///< the number done
    int lastId_ = 0;
    int revision_ = 0;
    int deeds_ = 0;
    std::size_t unchanged_ = 0;  ///< entries that are as takeUnchanged() left them
    std::set<int> tears_;
    std::optional<int> noted_;  ///< id of the last command, while it may still be extended
    std::optional<int> firstChange_;
    std::optional<int> takenOver_;           ///< last id before the user took over
    std::vector<LogEntry> rest_;             ///< dropped rest of the session
    std::optional<SessionEvent> lastPose_;   ///< while the user's blade is placed
    std::map<int, SessionEvent> lastDrags_;  ///< of hands that hold something, by number
};

}  // namespace kerf::app

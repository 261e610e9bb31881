#pragma once

#include <map>
#include <optional>
#include <vector>

#include "app/scene/timeline/changed_part.h"
#include "app/session/session.h"
#include "sim/run/simulation.h"

namespace kerf::app {

/// An event in a journal.
struct JournalEntry {
    enum class Origin {
        session,  ///< that is played
        person,
        editor,  ///< of itself: a check of a recording, or where a move was cut short
    };

    int id = 0;  ///< of this entry alone
    Origin origin = Origin::editor;
    SessionEvent event;
    bool failed = false;    ///< a command that could not be carried out when it was played
    bool doubtful = false;  ///< a check: something before it has changed since it was written
    /// What a doubtful check found when it was played, instead of what it says.
    std::optional<CheckEvent> found;
};

/// A place in a journal: before a step, behind an entry (its id, 0 for none).
struct JournalPlace {
    int step = 0;
    int behind = 0;
};

/// Writes down all that is done to a simulation since its start, so that it can be saved as a
/// session that replays to the same bits. Where a session is played it holds the session's events
/// too, those to come included, and what a person adds stands among them at the present.
class SessionJournal {
  public:
    /// Notes a command of a person that is executed before step `step`, which never falls while no
    /// session is played. What the person had set a parameter or a box to later is void then.
    void note(int step, const Command& command);
    /// Notes a check that a recording makes.
    void note(int step, CheckEvent check);
    void clear();

    // A session that is played.
    /// Begins anew with its events, all of them to come.
    void open(const std::vector<SessionEvent>& events);
    /// Begins it again: what a person did is forgotten. Pictures, exports and checks stay.
    void restart();
    /// The next event where it is due before `step`, which counts as done then; else null.
    JournalEntry* takeDue(int step);
    /// Commands that are done so far of those before the coming step `step`: with the step, what
    /// goTo() takes.
    std::size_t commandsDone(int step) const;
    /// Another present: before `step`, when so many of its commands were done.
    void goTo(int step, std::size_t commandsDone);
    /// A person goes on alone at `step`: what is to come is left out, the person's own for good.
    /// `cutShort`: the poses before the last step of the moves that end here on their way. Returns
    /// how many events of the person these were.
    std::size_t takeOver(int step, const std::vector<PlayedAction>& cutShort);

    /// What came of an entry when it was played: whether it could not be carried out, or what a
    /// doubtful check found.
    void noteFailure(JournalEntry& entry, bool failed);
    void noteFound(JournalEntry& entry, CheckEvent found);

    // Pictures, exports and checks.
    /// The present, before step `step`.
    JournalPlace here(int step) const;
    /// Adds one that a person wants.
    void add(const JournalPlace& place, SessionAction action);
    void remove(int id);

    const std::vector<JournalEntry>& entries() const { return entries_; }
    /// The first step before which a person changed the run of a played session or took it over.
    std::optional<int> firstChange() const { return firstChange_; }
    /// The entries that have changed since the last call, as they are saved; all where `whole`.
    ChangedPart::Splice takeChanged(bool whole) { return changed_.take(entries_.size(), whole); }
    /// So many things a person has done, or has had done.
    int deeds() const { return deeds_; }
    /// Events of the session that were to come when a person took over.
    std::size_t leftOut() const;
    /// Step of the last entry; 0 where there is none.
    int lastStep() const { return entries_.empty() ? 0 : entries_.back().event.step; }
    /// Grows when entries come or go that are no commands.
    int revision() const { return revision_; }

  private:
    JournalEntry& insert(std::size_t index, JournalEntry::Origin origin, SessionEvent event);
    std::size_t indexOf(const JournalPlace& place) const;
    bool mergeIntoLast(int step, const Command& command);
    void voidLater(const Command& command);
    void doubtChecksFrom(std::size_t index);
    void notePose(int step, const Command& command);
    void noteHand(int step, const Command& command);
    void hold(const SessionEvent& last, int step);
    std::size_t leaveOutRest();
    void dropTakeOver();
    void noteChangeAt(int step);
    void touch(std::size_t begin, std::size_t end) { changed_.touch(begin, end, entries_.size()); }
    void touchAll() { touch(0, entries_.size()); }
    void touch(const JournalEntry& entry);

    std::vector<JournalEntry> entries_;  ///< by step
    std::size_t done_ = 0;               ///< so many of them
    int lastId_ = 0;
    int revision_ = 0;
    int deeds_ = 0;
    ChangedPart changed_;
    std::optional<int> noted_;  ///< id of the last command, while it may still be extended
    std::optional<int> firstChange_;
    std::optional<int> takenOver_;           ///< last id before a person took over
    std::vector<JournalEntry> rest_;         ///< what was to come of the session
    std::optional<SessionEvent> lastPose_;   ///< while a person's blade is placed
    std::map<int, SessionEvent> lastDrags_;  ///< of hands that hold something, by number
};

}  // namespace kerf::app

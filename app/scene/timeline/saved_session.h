#pragma once

#include <optional>
#include <string>

#include "app/scene/timeline/session_journal.h"
#include "app/session/session_runner.h"

namespace kerf::app {

/// A session as the editor saves it.
struct SavedSession {
    Session session;
    /// Names the events that are not in it as they were, and why: one sentence; empty for none.
    std::string remark;
};

/// The purpose for which a session is saved.
enum class SavedAs {
    session,
    test,  ///< without the editor's own checks: the expectation beside it says more
};

/// A session with the events of its journal, where an opened one was played or a person did all.
/// Checks that a change before them left in doubt say what was found, where they were played since;
/// otherwise they lose their state hash. What could not be carried out after a change is left out.
SavedSession sessionAsSaved(const Session& opened, const SessionJournal& journal,
                            SavedAs purpose = SavedAs::session);

/// An event of a journal as it is saved; none where it is not. `changed`: a person has done
/// something before or after it.
std::optional<SessionEvent> eventAsSaved(const JournalEntry& entry, bool changed);

/// A check of what is found instead of what differs.
CheckEvent corrected(CheckEvent check, const CheckDifference& difference);

}  // namespace kerf::app

#pragma once

#include "app/scene/timeline/event_log.h"
#include "app/session/simulation_driver.h"

namespace kerf::app {

/// A session saved by the editor.
struct SavedSession {
    Session session;
    /// Events that were changed or dropped, and why: one sentence; empty for none.
    std::string remark;
};

/// The purpose for which a session is saved.
enum class SavedAs {
    session,
    test,  ///< without the editor's own checks, since there is an expectation
};

/// A session with the events of its log, from an opened session or from user actions. Checks
/// invalidated by an earlier change get the values found if played since; otherwise they lose their
/// state hash. Commands that failed after a change are omitted.
SavedSession sessionAsSaved(const Session& opened, const EventLog& log,
                            SavedAs purpose = SavedAs::session);

/// A log entry as a saved event; none if it is not saved. `changed`: the user has changed
/// something before or after it.
std::optional<SessionEvent> eventAsSaved(const LogEntry& entry, bool changed);

/// A check with the values found.
CheckEvent corrected(CheckEvent check, const CheckDifference& difference);

}  // namespace kerf::app

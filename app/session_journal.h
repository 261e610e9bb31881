#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/session.h"
#include "sim/simulation.h"

namespace kerf::app {

/// Writes down all that is done to a simulation since its start, so that it can be saved as a
/// session that replays to the same bits.
class SessionJournal {
  public:
    /// `command` is executed before step `step`, which never falls.
    void note(int step, const Command& command);
    void note(int step, CheckEvent check) { events_.push_back({step, std::move(check)}); }
    void clear() { *this = SessionJournal{}; }

    /// How far it is written, to come back to.
    struct Mark {
        std::size_t events = 0;
        std::optional<SessionEvent> lastPose;
    };
    Mark mark() const { return {events_.size(), lastPose_}; }
    void goBackTo(const Mark& mark);

    const std::vector<SessionEvent>& events() const { return events_; }

  private:
    void holdBlade(int step);

    std::vector<SessionEvent> events_;
    std::optional<SessionEvent> lastPose_;  ///< while the blade is placed
};

}  // namespace kerf::app

#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/session/session.h"
#include "sim/run/simulation.h"

namespace kerf::app {

/// Writes down all that is done to a simulation since its start, so that it can be saved as a
/// session that replays to the same bits.
class SessionJournal {
  public:
    /// Notes a command that is executed before step `step`, which never falls.
    void note(int step, const Command& command);
    void note(int step, CheckEvent check) { events_.push_back({step, std::move(check)}); }
    void clear() { *this = SessionJournal{}; }

    /// A state of the journal, to come back to.
    struct Mark {
        std::size_t events = 0;
        std::optional<SessionEvent> lastPose;
        std::map<int, SessionEvent> lastDrags;
    };
    Mark mark() const { return {events_.size(), lastPose_, lastDrags_}; }
    void goBackTo(const Mark& mark);

    const std::vector<SessionEvent>& events() const { return events_; }

  private:
    void notePose(int step, const Command& command);
    void noteHand(int step, const Command& command);
    void hold(const SessionEvent& last, int step);

    std::vector<SessionEvent> events_;
    std::optional<SessionEvent> lastPose_;   ///< while the blade is placed
    std::map<int, SessionEvent> lastDrags_;  ///< of hands that hold something, by number
};

}  // namespace kerf::app

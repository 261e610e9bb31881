#pragma once

#include "app/session/simulation_driver.h"

namespace kerf::app {

/// A session during playback: its events, and the first failed check.
class SessionPlayback {
  public:
    enum class Of {
        session,  ///< that was opened
        past,     ///< what was done here; it ends at the present
    };
    SessionPlayback(Session session, Of what);
    SessionPlayback(const SessionPlayback&) = delete;  // the schedule points into it
    SessionPlayback& operator=(const SessionPlayback&) = delete;

    bool isPast() const { return what_ == Of::past; }
    int steps() const { return steps_; }
    /// Extends the session to step `step`.
    void extendTo(int step) { steps_ = std::max(steps_, step); }
    bool loop = false;

    const SessionSchedule& schedule() const { return schedule_; }

    /// Records the result of a check of an unchanged session before step `step`. Returns "" or one
    /// sentence.
    std::string compare(const CheckEvent& check, const CheckDifference& difference, int step);
    /// The first step at which a check failed.
    std::optional<int> divergedAt() const { return divergedAt_; }

  private:
    Session session_;
    Of what_;
    int steps_;
    SessionSchedule schedule_{session_};
    std::optional<int> divergedAt_;
};

}  // namespace kerf::app

#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/session/session_runner.h"
#include "sim/run/moment.h"

namespace kerf::app {

/// A moment at which a played session can be taken up again.
struct Keyframe {
    Moment moment;
    std::size_t commandsDone = 0;    ///< in the journal
    std::vector<Blade> strokePoses;  ///< poses of the running stroke
};

/// An open session as it is played: what happens when, moments to scrub back to, and where it
/// first came out differently from what its checks say.
class SessionPlayback {
  public:
    /// The session must outlive it.
    explicit SessionPlayback(const Session& session);

    int steps() const { return steps_; }
    /// A person lets the session go on until step `step`.
    void extendTo(int step) { steps_ = std::max(steps_, step); }
    bool loop = false;

    const SessionPlayer& player() const { return player_; }

    /// Tells whether a keyframe is due before the actions of the coming step.
    bool wantsKeyframe(int step) const;
    void keep(int step, Keyframe keyframe, std::size_t bytes);
    /// The last keyframe at or before `step`; null where there is none.
    const Keyframe* keyframeBefore(int step) const;
    /// Step of the last keyframe at or before `step`; -1 where there is none.
    int keyframeStepBefore(int step) const;
    /// A person changes something before step `step`, when so many commands are done: keyframes
    /// behind that no longer hold.
    void changedAt(int step, std::size_t commandsDone);

    /// Takes note of how a check of an unchanged session came out before step `step`. Returns "" or
    /// one sentence.
    std::string compare(const CheckEvent& check, const CheckDifference& difference, int step);
    /// The first step at which a check failed.
    std::optional<int> divergedAt() const { return divergedAt_; }

  private:
    void thinOut();

    int steps_;
    SessionPlayer player_;
    std::map<int, Keyframe> keyframes_;  ///< by step
    int spacing_ = 1;                    ///< steps between two keyframes
    std::optional<int> divergedAt_;
};

}  // namespace kerf::app

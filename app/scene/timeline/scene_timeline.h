#pragma once

#include "app/scene/document/scene_body.h"
#include "app/scene/timeline/checkpoints.h"
#include "app/scene/timeline/event_log.h"
#include "app/scene/timeline/session_playback.h"

namespace kerf::ui {
struct PlaybackState;
}

namespace kerf::app {

/// The timeline of a scene: the played session, or what was done since the start, and seeking in
/// it.
class SceneTimeline {
  public:
    /// `body` must outlive it.
    explicit SceneTimeline(SceneBody& body);

    bool playing = false;  ///< whether time runs
    /// What the panels count from.
    const CountStart& start() const { return start_; }
    /// Simulated, since then [s].
    double time() const { return body_.simulation.report().time - start_.time; }
    /// Makes the panels count from the present.
    void countFromHere();

    /// Carries out a user command: the only way to the simulation. Returns "" or one sentence.
    std::string perform(const Command& wanted);
    const EventLog& log() const { return log_; }
    EventLog& log() { return log_; }
    /// Whether a user has changed anything since the start.
    bool hasChanged() const { return log_.firstChange().has_value(); }
    /// Whether time that runs beyond the end of a session belongs to it: after a change, and where
    /// it was reopened at its end.
    bool goesOn() const { return reopened_ || hasChanged(); }
    void noteReopened() { reopened_ = true; }

    /// Begins, paused, with a simulation at its start, and a session at its first event.
    void startAnew();
    /// Drops the session, and all that was done.
    void forgetSession();

    // The session that is played, or the past.
    /// None if nothing is played.
    const SessionPlayback* playback() const { return playback_ ? &*playback_ : nullptr; }
    /// Whether events of it are still to come.
    bool playingBack() const;
    /// Whether later user actions are still to come.
    bool inThePast() const { return playback_ && playback_->isPast(); }
    /// Does what is due before the coming step. Returns whether the panels must restart counting.
    bool playEvents();
    /// Whether playback continues after an undo or a redo: between two strokes and pulls, if no
    /// shape is restored.
    bool playsOnAfter(const Command& command) const;
    /// The user cuts or pulls: discards the rest of the playback.
    void takeOver();
    /// Releases all hands except hooks, as after an undo or a redo.
    void releaseHandsButHooks();
    /// Extends the playback to at least `step`.
    void extendTo(int step);
    void toggleLoop();

    // Seeking.
    /// The present as a checkpoint.
    SceneCheckpoint now() const;
    /// Keeps it, if one is due.
    void keepCheckpoint();
    /// Whether an earlier step is kept.
    bool goesBack(int step) const;
    /// Plays back from now on what was done since the start.
    void playPast();
    /// The immediate result of a seek.
    struct Jump {
        bool countsAnew = false;  ///< the panels count from another start
    };
    /// Seeks to `step` of the playback, before its events, or to the last checkpoint before it:
    /// seekSteps() are left to do. None if nothing was done at once.
    std::optional<Jump> seek(int step);
    /// Goes to the stored end of the opened session. False, and at its start, if it doesn't fit.
    bool goTo(const StoredEnd& end);
    /// Whether what was done before a stored end could be undone only after recall().
    bool hasForgotten() const;
    /// Begins to play all that was done again, which brings the undo history back: seekSteps() are
    /// left to do.
    void recall();
    int seekSteps() const;
    void stopSeeking() { seekTarget_.reset(); }

    /// Marks the step of `report` where a tear begins in it.
    void noteTear(const StepReport& report);

    /// The result of the end of a step.
    struct StepEnd {
        bool countsAnew = false;  ///< see playEvents()
        bool loops = false;       ///< it restarts
    };
    /// At its end a session stops once, or restarts. User changes stay.
    StepEnd endStep();

    /// What the checkpoints take [bytes].
    std::size_t checkpointBytes() const { return checkpoints_.bytes(); }
    /// Fills in what the panels show of it.
    void describe(ui::PlaybackState& state) const;

  private:
    static constexpr int kTearPause = 20;  ///< steps at rest, after which it is another tear
    void beginPlayback();
    long strokesThatMet() const;
    std::vector<PlayedAction> movesOnTheirWay() const;
    bool play(LogEntry& entry);
    void tell(std::string message);
    Jump goTo(int step, const SceneCheckpoint& checkpoint);
    StepEnd endSession();
    void endPast();

    SceneBody& body_;
    int toreLast_ = -kTearPause;  ///< step in which a tear advanced
    long metBefore_ = 0;          ///< strokes that had met the body when the blade was put down
    EventLog log_;
    /// Plays a session with events, or the past, until the user cuts.
    std::optional<SessionPlayback> playback_;
    Checkpoints checkpoints_;
    std::optional<int> seekTarget_;
    std::optional<int> undoBegins_;  ///< the step of a stored end
    bool reopened_ = false;          ///< the session was opened at its end
    CountStart start_;
};

}  // namespace kerf::app

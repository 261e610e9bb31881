#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/scene/document/scene_body.h"
#include "app/scene/timeline/keyframes.h"
#include "app/scene/timeline/session_journal.h"
#include "app/scene/timeline/session_playback.h"

namespace kerf::ui {
struct PlaybackState;
}

namespace kerf::app {

/// The steps of a scene: the session that is played, or what was done since the start, and moving
/// about in it.
class SceneTimeline {
  public:
    /// `body` must outlive it.
    explicit SceneTimeline(SceneBody& body);

    bool playing = false;  ///< whether time runs
    /// What the panels count from.
    const CountStart& start() const { return start_; }
    /// Simulated, since then [s].
    double time() const { return body_.simulation.report().time - start_.time; }
    /// The panels count from the present on.
    void countFromHere();

    /// Carries out a command of a person: the one way in which they reach the simulation. Returns
    /// "" or one sentence.
    std::string perform(const Command& wanted);
    const SessionJournal& journal() const { return journal_; }
    SessionJournal& journal() { return journal_; }
    /// Whether a person has changed anything since the start.
    bool hasChanged() const { return journal_.firstChange().has_value(); }

    /// Begins, paused, with a simulation at its start: the session from its first event, where
    /// there is one.
    void startAnew();
    /// Drops the session, and all that was done.
    void forgetSession();

    // The session that is played, or the past.
    /// None where the present is that of a person.
    const SessionPlayback* playback() const { return playback_ ? &*playback_ : nullptr; }
    /// Whether events of it are still to come.
    bool playingBack() const;
    /// Whether what was done after the present is still to come.
    bool inThePast() const { return playback_ && playback_->isPast(); }
    /// Does what is due before the coming step. True where the panels count anew from there.
    bool playEvents();
    /// Whether it goes on after an undo or a redo: between two strokes and pulls, where no shape
    /// comes back.
    bool playsOnAfter(const Command& command) const;
    /// A person takes the blade or the body in hand: what is left of it is off.
    void takeOver();
    /// Lets go of what nobody drags any more, as after an undo or a redo: all hands but hooks.
    void releaseHandsButHooks();
    /// Lets it go on until `step` at least.
    void extendTo(int step);
    void toggleLoop();

    // Seeking.
    /// Keeps the present, where that is due.
    void keepKeyframe();
    /// Whether an earlier step is kept.
    bool goesBack(int step) const;
    /// What was done since the start is played from now on.
    void playPast();
    /// What a seek has done at once.
    struct Jump {
        bool countsAnew = false;  ///< the panels count from another start
    };
    /// Goes to `step` of what is played, or as near before it as a keyframe is: seekSteps() are
    /// left to do. None where nothing was done at once.
    std::optional<Jump> seek(int step);
    int seekSteps() const;
    void stopSeeking() { seekTarget_.reset(); }

    /// What the end of a step brings.
    struct StepEnd {
        bool countsAnew = false;  ///< see playEvents()
        bool loops = false;       ///< it begins again
    };
    /// At its end a session stops once, or begins again. What a person changed goes on.
    StepEnd endStep();

    /// Fills in what the panels show of it.
    void describe(ui::PlaybackState& state) const;

  private:
    void beginPlayback();
    std::vector<PlayedAction> movesOnTheirWay() const;
    bool play(JournalEntry& entry);
    void tell(std::string message);
    Jump goTo(int step, const Keyframe& keyframe);
    StepEnd endSession();
    void endPast();

    SceneBody& body_;
    SessionJournal journal_;
    /// Plays a session with events, or the past, until a person cuts.
    std::optional<SessionPlayback> playback_;
    Keyframes keyframes_;
    std::optional<int> seekTarget_;
    CountStart start_;
};

}  // namespace kerf::app

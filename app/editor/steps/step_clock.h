#pragma once

#include <deque>

#include "app/scene/readout/editor_readings.h"
#include "sim/base/stopwatch.h"
#include "ui/state/window_state.h"

namespace kerf::app {

class EditorScene;

/// Turns the time between two frames into steps, and measures frame times while time runs.
class StepClock {
  public:
    static constexpr double kSlowest = 0.25;
    static constexpr double kFastest = 4;

    /// With `byTheClock` simulated time follows real time, and a step is done in portions [s];
    /// otherwise every frame is one step at speed 1, for tests.
    /// A body whose steps take longer than `slowStep` [s] is slow.
    StepClock(bool byTheClock, double portion, double slowStep = 1)
        : byTheClock_(byTheClock), portion_(portion), slowStep_(slowStep) {}

    bool byTheClock() const { return byTheClock_; }
    double speed() const { return speed_; }
    /// Sets the speed, clamped to kSlowest and kFastest.
    void setSpeed(double factor);

    /// Adds the time between two frames [s].
    void elapse(double seconds);
    /// Lets the time since the last call become due; delays beyond a tenth of a second are dropped.
    void passTime(double timeStep);
    /// Whole steps that are due.
    int due() const { return static_cast<int>(due_); }
    /// Runs up to `needed` steps, and up to `most` while they are faster still.
    void run(EditorScene& scene, int needed, int most);
    /// Whether steps take so long that pictures should wait for several of them.
    bool isSlow() const;
    /// How long the scene may work between two frames [s]; infinite if not by the clock.
    double portion() const;
    /// How long a step took when one was last run [s].
    double secondsPerStep() const { return secondsPerStep_; }
    double slowStep() const { return slowStep_; }
    /// Pauses: nothing is due, and the next visible steps end no frame.
    void stop();
    /// Another scene is open: how long its steps take is not known.
    void begin();

    /// Whether nothing was measured since the last pause.
    bool starts() const { return !ranBefore_; }
    /// Records that new steps are visible. Returns the time since the last ones.
    FrameTime measure();

  private:
    bool byTheClock_;
    double portion_;
    double slowStep_;
    double speed_ = 1;
    double due_ = 0;          ///< steps
    double sinceDue_ = 0;     ///< [s]
    double sinceShown_ = 0;   ///< [s]
    double stepSeconds_ = 0;  ///< in steps, since measure() [s]
    double secondsPerStep_ = 0;
    bool ranBefore_ = false;
};

/// Estimates how long work still takes, from its rate over the last seconds. The estimate runs down
/// with the clock and approaches a new rate slowly, so that it does not jump.
class TimeLeft {
  public:
    /// Sets the times of `work`, which begins anew where its title changes.
    void follow(ui::WorkState& work);
    /// The estimate once `done` of `all` parts are done, `seconds` after the start [s]; none
    /// without a rate.
    std::optional<double> at(double seconds, double done, double all);

  private:
    struct Sample {
        double seconds = 0;
        double done = 0;
    };
    void note(const Sample& now);

    std::string title_;
    Stopwatch watch_;
    std::deque<Sample> samples_;  ///< where more was done, oldest first
    std::optional<double> left_;  ///< [s]
    double last_ = 0;             ///< when it was estimated [s]
};

}  // namespace kerf::app

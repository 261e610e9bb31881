#pragma once

#include <optional>

namespace kerf::app {

class EditorScene;

/// Turns the time between two pictures into steps, and tells which pictures follow each other while
/// time runs.
class StepClock {
  public:
    static constexpr double kSlowest = 0.25;
    static constexpr double kFastest = 4;

    /// Simulated time follows real time with `byTheClock`, and a step is done in portions [s];
    /// otherwise every picture is one step at speed 1, for tests.
    StepClock(bool byTheClock, double portion) : byTheClock_(byTheClock), portion_(portion) {}

    bool byTheClock() const { return byTheClock_; }
    double speed() const { return speed_; }
    /// Sets the speed, clamped to kSlowest and kFastest.
    void setSpeed(double factor);

    /// Notes the time between two pictures [s].
    void elapse(double seconds);
    /// Steps that are due since this was last asked; what a slow picture leaves behind is not
    /// caught up with.
    int takeDue(double timeStep);
    /// Runs up to `needed` steps, and up to `due` ones while they are faster still.
    void run(EditorScene& scene, int needed, int due);
    /// How long the scene may work between two pictures [s]; infinite where not by the clock.
    double portion() const;
    /// How long a step took when one was last run [s].
    double secondsPerStep() const { return secondsPerStep_; }
    /// Time stands still: nothing is due, and the next steps to be seen end no frame.
    void stop();

    /// Notes that new steps are to be seen. Returns the frame time where time has not stood still
    /// since steps were to be seen before [s].
    std::optional<double> measure();

  private:
    bool byTheClock_;
    double portion_;
    double speed_ = 1;
    double due_ = 0;         ///< steps
    double sinceDue_ = 0;    ///< [s]
    double sinceShown_ = 0;  ///< [s]
    double secondsPerStep_ = 0;
    bool ranBefore_ = false;
};

}  // namespace kerf::app

#pragma once

#include <optional>

namespace kerf::app {

class EditorScene;

/// Turns the time between two frames into steps, and measures frame times while time runs.
class StepClock {
  public:
    static constexpr double kSlowest = 0.25;
    static constexpr double kFastest = 4;

    /// With `byTheClock` simulated time follows real time, and a step is done in portions [s];
    /// otherwise every frame is one step at speed 1, for tests.
    StepClock(bool byTheClock, double portion) : byTheClock_(byTheClock), portion_(portion) {}

    bool byTheClock() const { return byTheClock_; }
    double speed() const { return speed_; }
    /// Sets the speed, clamped to kSlowest and kFastest.
    void setSpeed(double factor);

    /// Adds the time between two frames [s].
    void elapse(double seconds);
    /// Steps due since the last call; delays by slow frames are dropped.
    int takeDue(double timeStep);
    /// Runs up to `needed` steps, and up to `due` ones while they are faster still.
    void run(EditorScene& scene, int needed, int due);
    /// How long the scene may work between two frames [s]; infinite if not by the clock.
    double portion() const;
    /// How long a step took when one was last run [s].
    double secondsPerStep() const { return secondsPerStep_; }
    /// Pauses: nothing is due, and the next visible steps end no frame.
    void stop();

    /// Records that new steps are visible. Returns the frame time [s], unless paused since the last
    /// ones.
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

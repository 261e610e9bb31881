#pragma once

namespace kerf::app {

class EditorScene;

/// Turns the time between two pictures into steps, and tells which pictures follow each other while
/// time runs.
class StepClock {
  public:
    static constexpr double kSlowest = 0.25;
    static constexpr double kFastest = 4;

    /// Simulated time follows real time with `byTheClock`; otherwise every picture is one step at
    /// speed 1, for tests.
    explicit StepClock(bool byTheClock) : byTheClock_(byTheClock) {}

    double speed() const { return speed_; }
    /// Sets the speed, clamped to kSlowest and kFastest.
    void setSpeed(double factor);

    /// Steps that are due for a picture `elapsedSeconds` after the last one; what a slow picture
    /// leaves behind is not caught up with.
    int takeDue(double elapsedSeconds, double timeStep);
    /// Runs `needed` steps whatever they cost, and up to `due` ones while they are fast.
    void run(EditorScene& scene, int needed, int due) const;
    /// Forgets what is due, since time stands still.
    void stop() { due_ = 0; }

    /// Notes a picture and whether steps ran for it. True where both it and the one before ran, so
    /// that the time between them is a frame time.
    bool measure(double elapsedSeconds, bool ran);

  private:
    bool byTheClock_;
    double speed_ = 1;
    double due_ = 0;  ///< steps
    bool ranBefore_ = false;
};

}  // namespace kerf::app

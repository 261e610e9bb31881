#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "render/camera.h"
#include "sim/command.h"

namespace kerf::app {

/// Turns points of the view into blades: A on a plane before the body, B on a plane behind it, both
/// square to the view direction, so that the blade is seen as a point and a straight stroke sweeps
/// a plane. The view it was made with stays.
class StrokeSpace {
  public:
    /// `bounds`: of the body as it is [m]; `aspect`: width over height of the view.
    StrokeSpace(const render::Camera& camera, double aspect, const Bounds& bounds);

    /// `ndc`: -1..1, y up.
    Blade bladeAt(const Vec2& ndc) const;
    /// How far two blades are apart in the middle of the body [m].
    double distance(const Blade& from, const Blade& to) const;
    /// The farthest that the blade may move in one step [m].
    double maxStep() const { return maxStep_; }

  private:
    render::Camera camera_;
    double aspect_;
    Vec3 forward_;
    double nearDepth_;    ///< of A, along the view direction [m]
    double farDepth_;     ///< of B
    double middleShare_;  ///< where the middle of the body lies between A (0) and B (1)
    double maxStep_;
};

/// A stroke as it is drawn and the blade poses still to be stepped through: one per simulation
/// step, in order, none dropped, long moves divided. The lift comes after the last pose, with a
/// step of its own.
class BladeStroke {
  public:
    /// The pointer went down. The blade appears once it moves: a mere click does nothing.
    void begin(const StrokeSpace& space, const Vec2& ndc);
    void moveTo(const Vec2& ndc);
    /// The pointer went up.
    void end();
    /// Forgets the poses still to come; where the blade already moves it is lifted.
    void cancel();
    /// Forgets everything, for a body that begins anew.
    void clear() { *this = BladeStroke{}; }

    bool drawing() const { return space_.has_value(); }
    std::size_t pending() const { return queue_.size(); }
    /// The command of the coming step.
    std::optional<Command> next();
    /// Poses done since the blade was placed; empty once lifted.
    const std::vector<Blade>& sweep() const { return sweep_; }

  private:
    void queueUpTo(const Blade& target);
    bool placed() const { return queued_.has_value(); }

    std::optional<StrokeSpace> space_;  ///< while the pointer is down
    Blade first_;                       ///< where the pointer went down
    std::optional<Blade> queued_;       ///< last pose put into the queue
    Blade latest_;                      ///< where the pointer is
    std::deque<Command> queue_;
    std::vector<Blade> sweep_;
};

}  // namespace kerf::app

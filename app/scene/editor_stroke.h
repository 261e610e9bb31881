#pragma once

#include <deque>

#include "render/scene/camera.h"
#include "sim/run/parts/command.h"

namespace kerf::app {

/// The resolution at which the path of a blade is divided into steps.
struct StrokeScale {
    double share = 0.5;  ///< the point of the blade that is measured: 0 at A, 1 at B
    double maxStep = 0;  ///< the farthest that it may move in one step [m]

    /// Distance between that point of one blade and of another [m].
    double distance(const Blade& from, const Blade& to) const;
};
/// The farthest that a blade may move in a step, for a body of these bounds [m].
double maxStrokeStep(const Bounds& bounds);

/// The progress of a stroke: poses done and queued since the queue was last empty.
struct StrokeProgress {
    std::size_t done = 0;
    std::size_t poses = 0;
};

/// Turns points of the view into blades: A on a plane before the body, B on a plane behind it, both
/// square to the view direction, so that the blade is seen as a point and a straight stroke sweeps
/// a plane. It keeps the view of its construction.
class StrokeSpace {
  public:
    /// `bounds` are those of the present body [m], `aspect` is width over height of the view, and B
    /// is `depth` behind the nearest point of the body [m]; without it, behind the body.
    StrokeSpace(const render::Camera& camera, double aspect, const Bounds& bounds,
                std::optional<double> depth = std::nullopt);

    /// The blade that is seen as the point `ndc` (-1..1, y up).
    Blade bladeAt(const Vec2& ndc) const;
    StrokeScale scale() const { return {middleShare_, maxStep_}; }
    /// Distance of two blades in the middle of the body [m].
    double distance(const Blade& from, const Blade& to) const { return scale().distance(from, to); }
    /// The farthest that the blade may move in one step [m].
    double maxStep() const { return maxStep_; }

  private:
    double nearestDepth(const Bounds& bounds) const;

    render::Camera camera_;
    double aspect_;
    Vec3 forward_;
    double nearDepth_;    ///< of A, along the view direction [m]
    double farDepth_;     ///< of B
    double middleShare_;  ///< where the middle of the body lies between A (0) and B (1)
    double maxStep_;
};

/// A stroke while it is drawn, and the queue of its poses: one per simulation step, in order, none
/// dropped, long moves divided. The lift comes after the last pose, with a separate step.
class BladeStroke {
  public:
    /// After a press of the button. The blade appears once the pointer moves: a click does nothing.
    void begin(const Blade& first, const StrokeScale& scale);
    void moveTo(const Blade& blade);
    /// Begins and continues a stroke by points of the view.
    void begin(const StrokeSpace& space, const Vec2& ndc);
    void moveTo(const Vec2& ndc);
    /// From now on strokes take as many steps of this length [s] as the hand takes time, and keep
    /// how long it is away between them; 0: as many as the way needs.
    void keepTime(double timeStep) { timeStep_ = timeStep; }
    /// From now on the blade moves at most that far in a step [m], beside the stroke's own limit.
    void limitStep(double farthest) { farthest_ = farthest; }
    /// Adds the real time [s] of a frame, before what happened in it.
    void elapse(double seconds);
    /// After the release of the button.
    void end();
    /// Drops the queued poses; lifts a blade that already moves.
    void cancel();
    /// Drops everything, for a restarted body.
    void clear() { *this = BladeStroke{}; }

    bool drawing() const { return scale_.has_value(); }
    std::size_t pending() const { return queue_.size(); }
    /// The strokes in the queue of which no pose is done yet.
    int waiting() const;
    StrokeProgress progress() const { return {given_, given_ + queue_.size()}; }
    /// The command of the coming step.
    std::optional<Command> next();
    /// The path still to be cut by the last stroke: from the last pose done, or its first one.
    std::vector<Blade> wayAhead() const;

  private:
    bool keepsTime() const { return timeStep_ > 0; }
    void queueWay();
    int stepsFor(double length, double seconds);
    void forgetPointer();
    bool placed() const { return queued_.has_value(); }

    std::optional<StrokeSpace> space_;  ///< of a stroke by points of the view
    std::optional<StrokeScale> scale_;  ///< while it is drawn
    Blade first_;                       ///< where the button was pressed
    std::optional<Blade> queued_;       ///< last queued pose
    Blade latest_;                      ///< where the pointer is
    std::vector<Blade> way_;            ///< on from there, not queued yet
    double elapsed_ = 0;                ///< since the last pose was queued, or the last lift [s]
    double timeStep_ = 0;               ///< see keepTime() [s]
    double farthest_ = std::numeric_limits<double>::infinity();  ///< see limitStep() [m]
    double owed_ = 0;  ///< steps that the hand took time for, not queued yet
    double away_ = 0;  ///< of the hand before this stroke [s]
    std::deque<Command> queue_;
    std::size_t given_ = 0;      ///< poses taken since the queue was last empty
    std::optional<Blade> done_;  ///< the last pose that was taken, until the lift
};

}  // namespace kerf::app

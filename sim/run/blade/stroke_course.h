#pragma once

#include <optional>
#include <vector>

#include "sim/contact/blade_body.h"
#include "sim/contact/edge_push.h"
#include "sim/run/blade/felt_edge.h"
#include "sim/run/parts/running_body.h"
#include "sim/run/parts/simulation_parts.h"
#include "sim/run/undo/undo_log.h"
#include "sim/solve/front_anchors.h"

namespace kerf {

/// The course of a stroke: it begins when the blade comes near the body, and ends when it has left
/// it.
class StrokeCourse {
  public:
    /// All must outlive the object.
    StrokeCourse(RunningBody& body, SimulationInput& input, UndoLog& log, SimulationOutput& output)
        : body_(body), input_(input), log_(log), output_(output) {}

    /// Carries out what the blade was told.
    void step();
    /// Whether the coming step ends a stroke that has begun.
    bool endsInStep() const;
    void lift();

    /// The blade's body where it pushes: see Simulation::bladeBody().
    std::optional<BladeMotion> bladeBody() const;
    /// bladeBody() in the coming step.
    std::optional<BladeMotion> bladeMotion() const;

    /// Whether the material holds the edge back where it is in it.
    bool feels() const { return edgeSpring().has_value(); }
    /// How the edge presses in the coming step; none where it touches nothing.
    std::optional<PressingEdge> pressingEdge() const;
    /// How the material holds the edge where it is now, but for work; nothing where it does not.
    HeldEdge heldEdge() const;

  private:
    void carryOut(const MoveBlade& move);
    void carryOut(const LiftBlade&) { lift(); }
    bool mayTouch(const Blade& to);
    void begin();
    void end();
    void accept(const CutResult& result);
    BladePush push() const;
    std::optional<EdgeSpring> edgeSpring() const;
    std::optional<FeltEdge> feltEdge() const;
    double lag() const;

    RunningBody& body_;
    SimulationInput& input_;
    UndoLog& log_;
    SimulationOutput& output_;
};

/// Holds the front of an unfinished slit for a step, until release(); where walls are absent, as in
/// the open course, what is hidden follows the body instead. See findFrontAnchors().
class FrontHold {
  public:
    /// The body must outlive it. `timeStep`: the coming one [s].
    FrontHold(RunningBody& body, double timeStep);
    void release();

  private:
    AnchorFrame frame(double timeStep) const;
    void carryHidden(double timeStep);

    RunningBody& body_;
    std::vector<Anchor> anchors_;
};

}  // namespace kerf

#pragma once

#include "sim/contact/blade_body.h"
#include "sim/contact/edge_push.h"
#include "sim/run/blade/felt_edge.h"
#include "sim/run/parts/running_body.h"
#include "sim/run/parts/simulation_parts.h"
#include "sim/run/undo/undo_log.h"
#include "sim/solve/front_anchors.h"

namespace kerf {

/// The course of a stroke, from the approach of the blade until it has left the body.
class RunningStroke {
  public:
    /// All must outlive the object.
    RunningStroke(RunningBody& body, SimulationInput& input, UndoLog& log, SimulationOutput& output)
        : body_(body), input_(input), log_(log), output_(output) {}

    /// Carries out the blade's commands.
    void step();
    /// Ends a stroke in progress, as lifting the blade does; the blade stays.
    void end();
    /// Whether the coming step ends a stroke in progress.
    bool endsInStep() const;
    void lift();

    /// The blade's body where it pushes: see Simulation::bladeBody().
    std::optional<BladeMotion> bladeBody() const;
    /// bladeBody() in the coming step.
    std::optional<BladeMotion> bladeMotion() const;

    /// Whether the material resists the edge.
    bool feels() const { return edgeSpring().has_value(); }
    /// The pressing edge in the coming step; none if it touches nothing.
    std::optional<PressingEdge> pressingEdge() const;
    /// The present resistance of the material, without work; none if it does not resist.
    HeldEdge heldEdge() const;

  private:
    void carryOut(const MoveBlade& move);
    void carryOut(const LiftBlade&) { lift(); }
    bool mayTouch(const Blade& to);
    bool isInStroke() const;
    void begin();
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

/// Anchors the front of an unfinished slit for a step, until release(); with absent walls, as in
/// the open cut, hidden vertices follow the body instead. See findFrontAnchors().
class FrontHold {
  public:
    /// The body and the parameters of the coming step must outlive it.
    FrontHold(RunningBody& body, const Params& params);
    void release();

  private:
    AnchorFrame frame() const;
    void carryHidden();

    RunningBody& body_;
    const Params& params_;
    std::vector<Anchor> anchors_;
};

}  // namespace kerf

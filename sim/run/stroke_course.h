#pragma once

#include <optional>

#include "sim/contact/blade_body.h"
#include "sim/run/running_body.h"
#include "sim/run/simulation_parts.h"
#include "sim/run/undo_log.h"

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
    void lift();

    /// The blade's body where it pushes: see Simulation::bladeBody().
    std::optional<BladeMotion> bladeBody() const;
    /// The same in the coming step.
    std::optional<BladeMotion> bladeMotion() const;

  private:
    void carryOut(const MoveBlade& move);
    void carryOut(const LiftBlade&) { lift(); }
    bool mayTouch(const Blade& to);
    void begin();
    void end();
    void accept(const CutResult& result);
    BladePush push() const;

    RunningBody& body_;
    SimulationInput& input_;
    UndoLog& log_;
    SimulationOutput& output_;
};

}  // namespace kerf

#pragma once

#include <type_traits>

#include "app/session/session.h"
#include "sim/run/simulation.h"

namespace kerf::app {

/// The values of a simulation that differ from a check; empty for none.
struct CheckDifference {
    std::optional<std::string> hash;  ///< state hash of the simulation
    std::optional<int> pieces;        ///< number of pieces
};

/// Runs a simulation through its steps and a session's events before each, for replays and the
/// editor.
class SimulationDriver {
  public:
    /// The simulation must outlive the driver.
    explicit SimulationDriver(Simulation& simulation) : simulation_(simulation) {}

    /// Passes the events before the coming step to `host`, in order: `host.perform(command,
    /// number)` for a command with its SessionEvent::number, `host.take(event)` for others.
    template <class Host>
    void applyActions(const SessionSchedule& schedule, Host&& host) const {
        for (const PlayedAction& played : schedule.actionsAt(simulation_.stepCount())) {
            const auto apply = [&](const auto& action) {
                if constexpr (std::is_constructible_v<Command, decltype(action)>) {
                    host.perform(Command(action), played.number);
                } else {
                    host.take(action);
                }
            };
            std::visit(apply, played.action);
        }
    }

    /// Runs one step and follows the blade.
    const StepReport& step();

    /// Compares the simulation with a check, before the coming step.
    CheckDifference compare(const CheckEvent& check) const;
    /// The invariants that this step broke, as parts of a sentence. Each is reported once, since
    /// later steps inherit the break.
    std::vector<std::string> newlyBroken(const StepReport& report);

    /// Poses of the blade after each step of the running stroke, drawn or played.
    const std::vector<Blade>& strokePoses() const { return strokePoses_; }
    void forgetStroke() { strokePoses_.clear(); }

    /// A checkpoint of the simulation, with the poses of the running stroke.
    struct State {
        Checkpoint checkpoint;
        std::vector<Blade> strokePoses;
    };
    /// The present.
    State now() const { return {simulation_.checkpoint(), strokePoses_}; }
    void goTo(const State& state);

  private:
    Simulation& simulation_;
    std::vector<Blade> strokePoses_;
    bool toldOpen_ = false;
    bool toldNotFinite_ = false;
};

}  // namespace kerf::app

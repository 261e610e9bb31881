#pragma once

#include "app/session/simulation_driver.h"

namespace kerf::app {

/// The start of time in the panels: the last restart.
struct CountStart {
    int step = 0;
    double time = 0;  ///< [s]
};

/// A state of a scene before a step, and its place in the event log.
struct SceneCheckpoint {
    SimulationDriver::State state;
    std::size_t commandsDone = 0;  ///< of the step
    CountStart start;
};

/// Checkpoints along a scene, more for smaller bodies: when the budget is used up, every other one
/// is dropped.
class Checkpoints {
  public:
    /// `spacing`: steps between two of them, at first.
    explicit Checkpoints(int spacing = kSpacing) : spacing_(spacing) {}

    /// Whether one is due before step `step`, for a body whose copy takes `bytes`: of a very large
    /// one only the first.
    bool wants(int step, std::size_t bytes) const;
    /// Whether one of such a body fits beside the first.
    bool fits(std::size_t bytes) const;
    void keep(int step, SceneCheckpoint checkpoint, std::size_t bytes);
    /// The step of the last one before `step`, or at it: there only with no command of that step,
    /// unless `any`; -1 for none.
    int stepBefore(int step, bool any) const;
    const SceneCheckpoint& at(int step) const { return byStep_.at(step).checkpoint; }
    /// After a change before step `step`, with `commandsDone` of its commands: drops later ones.
    void changedAt(int step, std::size_t commandsDone);
    /// About what they take together [bytes].
    std::size_t bytes() const;

  private:
    static constexpr int kSpacing = 50;
    struct Kept {
        SceneCheckpoint checkpoint;
        std::size_t bytes = 0;
    };
    void thinOut();

    std::map<int, Kept> byStep_;
    int spacing_;
};

}  // namespace kerf::app

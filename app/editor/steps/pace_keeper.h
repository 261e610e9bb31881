#pragma once

#include <optional>
#include <string>

#include "app/scene/readout/editor_readings.h"
#include "sim/base/params.h"
#include "sim/solve/sweep_strength.h"

namespace kerf::app {

class EditorScene;

/// How finely time is divided.
struct StepDivision {
    double timeStep = 0;  ///< [s]
    int iterations = 0;
    bool operator==(const StepDivision&) const = default;
};

/// What a step takes on this machine, with its share of the pictures [s].
struct StepCost {
    double fixed = 0;
    double perIteration = 0;

    /// The real-time factor.
    double factor(const StepDivision& steps) const {
        return steps.timeStep / (fixed + steps.iterations * perIteration);
    }
};

inline constexpr int kFewestPaced = 8;
/// The division with the least error among those that keep up with the clock, with some to spare,
/// or else the coarsest one: 10 ms with the `fewest` iterations. It is no finer than `accurate`,
/// whose other parameters count, too.
StepDivision keepingPace(const SweepStrength& sweeps, const Params& accurate, const StepCost& cost,
                         int fewest = kFewestPaced);

/// Keeps a scene in pace with the clock, as far as it can: sets `time_step` and `iterations` as a
/// person would, by what steps take here. A person who sets either ends it, and has the other one
/// back.
class PaceKeeper {
  public:
    bool isOn() const { return on_; }
    /// Begins, or gives the scene the parameters from before.
    void toggle(EditorScene& scene);
    /// Begins anew with another scene.
    void begin() {
        before_.reset();
        fewest_ = kFewestPaced;
    }
    /// Looks after a picture whether another division would be clearly better. Not while a session
    /// plays, whose steps are its own.
    void follow(EditorScene& scene, const FrameTime& frame);
    /// What it costs: "about 20 % too soft"; "" while it is off.
    std::string cost(const SweepStrength& sweeps, const Params& now) const;

  private:
    void look(EditorScene& scene, const FrameTime& frame);
    void takeCoarsest(EditorScene& scene);
    void take(EditorScene& scene, const StepDivision& steps);
    void count(const EditorScene& scene);

    bool on_ = false;
    std::optional<Params> before_;  ///< of this scene; none before anything was set
    StepDivision taken_;
    int fewest_ = kFewestPaced;  ///< with which the scene keeps its volume
    FrameTime passed_;           ///< since the last look
    int fromStep_ = 0;
};

}  // namespace kerf::app

#pragma once

#include "sim/cut/blade.h"
#include "sim/run/moment.h"

namespace kerf::app {

/// The start of time in the panels: the last restart.
struct CountStart {
    int step = 0;
    double time = 0;  ///< [s]
};

/// A checkpoint of a scene, for seeking.
struct Keyframe {
    Moment moment;
    std::size_t commandsDone = 0;    ///< in the journal, before the coming step
    std::vector<Blade> strokePoses;  ///< poses of the running stroke
    CountStart start;
};

/// Checkpoints along a scene, more for smaller bodies: when the budget is used up, every other one
/// is dropped.
class Keyframes {
  public:
    /// `spacing`: steps between two of them, at first.
    explicit Keyframes(int spacing = kSpacing) : spacing_(spacing) {}

    /// Whether one is due before step `step`, for a body whose copy takes `bytes`: of a very large
    /// one only the first.
    bool wants(int step, std::size_t bytes) const;
    /// Whether one of such a body fits beside the first.
    bool fits(std::size_t bytes) const;
    void keep(int step, Keyframe keyframe, std::size_t bytes);
    bool empty() const { return byStep_.empty(); }
    /// The last one at or before `step`; null for none.
    const Keyframe* before(int step) const;
    /// Step of the last one at or before `step`; -1 for none.
    int stepBefore(int step) const;
    /// After a change before step `step`, with `commandsDone` of its commands: drops later ones.
    void changedAt(int step, std::size_t commandsDone);

  private:
    static constexpr int kSpacing = 50;
    void thinOut();

    std::map<int, Keyframe> byStep_;
    int spacing_;
};

}  // namespace kerf::app

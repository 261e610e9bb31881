#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "sim/cut/blade.h"
#include "sim/run/moment.h"

namespace kerf::app {

/// What the panels count from: the last restart.
struct CountStart {
    int step = 0;
    double time = 0;  ///< [s]
};

/// A moment at which the course of a scene can be taken up again.
struct Keyframe {
    Moment moment;
    std::size_t commandsDone = 0;    ///< of the coming step, in the journal
    std::vector<Blade> strokePoses;  ///< poses of the running stroke
    CountStart start;
};

/// Moments all along the course of a scene, the more of them the smaller the body: where their
/// budget is used up, every other one goes.
class Keyframes {
  public:
    /// `spacing`: steps between two of them, at first.
    explicit Keyframes(int spacing = kSpacing) : spacing_(spacing) {}

    /// Whether one is due before step `step`, of a body whose copy takes `bytes`: of a very large
    /// one the first alone.
    bool wants(int step, std::size_t bytes) const;
    void keep(int step, Keyframe keyframe, std::size_t bytes);
    bool empty() const { return byStep_.empty(); }
    /// The last one at or before `step`; null where there is none.
    const Keyframe* before(int step) const;
    /// Step of the last one at or before `step`; -1 where there is none.
    int stepBefore(int step) const;
    /// Something changes before step `step`, when so many of its commands are done: those behind
    /// that no longer hold.
    void changedAt(int step, std::size_t commandsDone);

  private:
    static constexpr int kSpacing = 50;
    void thinOut();

    std::map<int, Keyframe> byStep_;
    int spacing_;
};

}  // namespace kerf::app

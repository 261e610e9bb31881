#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "gpu/timer.h"
#include "sim/solve/collisions.h"
#include "sim/solve/implicit_stepper.h"
#include "sim/solve/small_body.h"
#include "sim/solve/solver_body.h"
#include "sim/solve/substep_phases.h"
#include "sim/solve/unfolding.h"

namespace kerf {

/// The choice between two ways to the same result: the one that was faster last time. Each is tried
/// twice first, since the first time compiles its kernels; the other one is retried occasionally,
/// since conditions may change.
class FasterWay {
  public:
    /// 0 or 1.
    std::size_t next() const {
        for (const std::size_t way : {std::size_t{0}, std::size_t{1}}) {
            if (tries_[way] < kTries) {
                return way;
            }
        }
        const std::size_t faster = last_[1] < last_[0] ? 1 : 0;
        return sinceOther_ < kOtherAfter ? faster : 1 - faster;
    }

    /// How long next() took, in any unit.
    void took(double time) {
        const std::size_t way = next();
        sinceOther_ = sinceOther_ < kOtherAfter ? sinceOther_ + 1 : 0;
        tries_[way] = std::min(tries_[way] + 1, kTries);
        last_[way] = time;
    }

    static constexpr int kTries = 2;
    static constexpr int kOtherAfter = 60;

  private:
    std::array<double, 2> last_{};
    std::array<int, 2> tries_{};
    int sinceOther_ = 0;
};

/// Runs the time steps of a body in the fastest way: with a dispatch for each phase of a substep,
/// or, for a small body, with one work group and a dispatch for a step, a substep or some sweeps.
/// The bits are the same.
class TimeStepper {
  public:
    /// Both must outlive it. Compiles the kernels: throws gpu::ShaderError.
    TimeStepper(SolverBody& body, Collisions& collisions)
        : body_(body), collisions_(collisions), phases_(body), unfolding_(body) {}

    /// Allocates for `vertices` vertices. Throws gpu::OutOfMemory.
    void makeRoom(std::size_t vertices) { unfolding_.resize(vertices); }
    /// A body that is new or changed.
    void setBody(const BodyModel& model, bool isNew);

    /// One time step: uniforms.substeps substeps of uniforms.sweeps sweeps, or as many implicit
    /// steps. Masses must be fresh. `heldMove`: whether any vertex without one has a velocity.
    void step(bool heldMove);
    /// Makes the coming time steps of implicit ones; null: of substeps, the default. It must
    /// outlive them. `unfolds`: whether they unfold what is folded.
    void stepImplicitly(ImplicitStepper* implicit, bool unfolds = true) {
        implicit_ = implicit;
        mayUnfold_ = unfolds;
    }
    /// Whether small bodies may be solved by one work group (the default), or in a dispatch for
    /// each phase like larger ones.
    void allowOneGroup(bool allowed) { oneGroupAllowed_ = allowed; }
    /// Whether the phases at the end of a substep may share a dispatch if only the floor can be hit
    /// (the default).
    void allowSettling(bool allowed) { settlingAllowed_ = allowed; }
    /// Whether a step of a large body waits for what each search for contacts finds, which saves
    /// the phases of contact where that is nothing. The results are the same.
    void waitForSearches(bool wanted) { waitsForSearches_ = wanted; }
    /// Replaces the group that solves a small body, its kernels with it; before setBody().
    void setSmallBody(SmallBodySolver solver) { smallBody_ = std::move(solver); }
    const SmallBodySolver& smallBody() const { return smallBody_; }
    /// Whether step() uses one group: in one dispatch, or in one for each substep if thin boxes or
    /// a pushing blade may be hit; plain PBD only if the floor alone may be hit. Large bodies take
    /// one for each phase, in plain PBD on llvmpipe whichever is faster.
    bool solvesInOneGroup() const;
    /// Whether the last measure saw a folded edge that the coming step unfolds (see Unfolding).
    bool unfolds() const { return collisions_.expectsFolds() && body_.active(shared::kUnfoldPart); }

    SubstepPhases& phases() { return phases_; }
    /// Runs before the phases of a substep, only if something is folded.
    void unfold() { unfolding_.run(body_, false); }

    /// GPU time of the steps since the last call [ms].
    double takeDeformMilliseconds() { return deformTimer_.takeMilliseconds(); }
    double takeCollideMilliseconds() { return collideTimer_.takeMilliseconds(); }

  private:
    void solve(bool heldMove);
    void stepByPhases();
    void stepBySweeps();
    void stepTheFasterWay();
    void stepAtOnce();
    std::uint32_t touchingSubstepsAtOnce() const;
    void stepTouching();
    void stepBySubsteps();
    bool sweepsInOneGroup() const;
    void holdVolumeAndCollide(std::uint32_t substep, bool last);
    /// `afterPhases`: of the substep before.
    void unfoldBefore(bool afterPhases);
    bool searchBefore(std::uint32_t substep);
    void stepImplicitly(bool heldMove);
    template <class Run>
    void runSmallBody(const Run& run);

    SolverBody& body_;
    Collisions& collisions_;
    SubstepPhases phases_;
    SmallBodySolver smallBody_;
    FasterWay sweepsFaster_;  ///< 0: in one group, 1: by phases
    Unfolding unfolding_;
    ImplicitStepper* implicit_ = nullptr;
    bool unfolds_ = false;  ///< in this step
    bool mayUnfold_ = true;
    bool oneGroupAllowed_ = true;
    bool settlingAllowed_ = true;
    bool waitsForSearches_ = true;
    gpu::ComputeTimer deformTimer_;
    gpu::ComputeTimer collideTimer_;
};

}  // namespace kerf

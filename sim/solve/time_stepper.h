#pragma once

#include <cstddef>
#include <cstdint>

#include "gpu/context.h"
#include "gpu/timer.h"
#include "sim/solve/collisions.h"
#include "sim/solve/implicit_stepper.h"
#include "sim/solve/solver_body.h"
#include "sim/solve/sweep_phases.h"
#include "sim/solve/unfolding.h"

namespace kerf {

/// Runs the time steps of a body: of implicit steps, or of sweeps of plain PBD.
class TimeStepper {
  public:
    /// Both must outlive it. Compiles the kernels: throws gpu::ShaderError.
    TimeStepper(SolverBody& body, Collisions& collisions)
        : body_(body), collisions_(collisions), phases_(body), unfolding_(body) {}

    /// Allocates for `vertices` vertices. Throws gpu::OutOfMemory.
    void makeRoom(std::size_t vertices) { unfolding_.resize(vertices); }

    /// One time step: uniforms.substeps implicit steps, or uniforms.sweeps sweeps. Masses must be
    /// fresh. `heldMove`: whether any vertex without one has a velocity.
    void step(bool heldMove);
    /// Makes the coming time steps of implicit ones; null: of sweeps, the default. It must outlive
    /// them. `unfolds`: whether they unfold what is folded.
    void stepImplicitly(ImplicitStepper* implicit, bool unfolds = true) {
        implicit_ = implicit;
        mayUnfold_ = unfolds;
    }
    /// Whether the last measure saw a folded edge that the coming step unfolds (see Unfolding).
    bool unfolds() const { return collisions_.expectsFolds() && body_.active(shared::kUnfoldPart); }

    SweepPhases& phases() { return phases_; }
    /// Runs before an implicit step, only if something is folded.
    void unfold() { unfolding_.run(body_); }

    /// GPU time of the steps since the last call [ms].
    double takeDeformMilliseconds() { return deformTimer_.takeMilliseconds(); }
    double takeCollideMilliseconds() { return collideTimer_.takeMilliseconds(); }

  private:
    template <class F>
    void timed(gpu::ComputeTimer& timer, F&& work);
    void stepImplicitly(bool heldMove);
    void sweep();
    void collide(bool last);
    void searchBefore(std::uint32_t substep);

    SolverBody& body_;
    Collisions& collisions_;
    SweepPhases phases_;
    Unfolding unfolding_;
    ImplicitStepper* implicit_ = nullptr;
    bool mayUnfold_ = true;
    bool onProcessors_ = gpu::queryDevice().software;
    gpu::ComputeTimer deformTimer_;
    gpu::ComputeTimer collideTimer_;
};

}  // namespace kerf

#pragma once

#include "gpu/buffer.h"
#include "gpu/context.h"
#include "gpu/program.h"
#include "gpu/timer.h"
#include "sim/solve/collisions.h"
#include "sim/solve/implicit_stepper.h"
#include "sim/solve/solver_body.h"

namespace kerf {

/// The phases of a step of plain PBD except contact, in a dispatch or two each; each ends with a
/// storage barrier, and does nothing if its part of the uniforms is off.
class SweepPhases {
  public:
    /// The body must outlive it. Compiles the kernels: throws gpu::ShaderError.
    explicit SweepPhases(SolverBody& body);

    void predictAndStretch();
    /// Solves the edges without a prediction: in all sweeps except the first.
    void stretchAgain();
    /// Solves the constraints of a type other than edges.
    void solve(std::uint32_t type);
    void pull();
    void collideFloor();
    /// The floor and the end of the step.
    void finish();

  private:
    void bindLists(std::uint32_t type) const;

    SolverBody& body_;
    gpu::Program stretch_, stretchAgain_;
    /// By type of constraint, except edges.
    std::array<gpu::Program, kConstraintTypes> solve_, gather_;
    gpu::Program pull_, floor_, finish_;
};

/// Unfolds a folded surface, on the GPU: elastic forces leave triangles inverted, since their edges
/// have the right lengths again. Between two steps the vertices around each edge that is bent by
/// more than 60 degrees from rest are pulled to their rest shape, by an overdamped spring that
/// changes no momentum, and that is damped more, so that it holds against loads, while no blade
/// cuts. Without folds no bit changes.
class Unfolding {
  public:
    /// Compiles the kernels. Throws gpu::ShaderError.
    explicit Unfolding(const SolverBody& body);
    /// Sets the number of vertices. Throws gpu::OutOfMemory.
    void resize(std::size_t vertices);
    /// Changes velocities.
    void run(SolverBody& body);
    /// The fold of the skin at each vertex, 0 to 1, after the last run: a float each.
    const gpu::Buffer& folds() const { return folds_; }

  private:
    void bind(const SolverBody& body) const;

    gpu::Program forgetFolds_, findFolds_, findGoals_, unfold_;
    gpu::Buffer folds_, goals_;
};

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

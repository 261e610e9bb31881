#pragma once

#include "shaders/shared/solver_uniforms.h"
#include "sim/body/body_model.h"

namespace kerf {

/// The state that the reference solver moves, shape [vertexCount]. Inside a step a vertex is at
/// positions + displacements; constraints only use differences (X_i - X_j) + (d_i - d_j), so that
/// floats on the GPU don't lose momentum.
struct ReferenceState {
    std::vector<Vec3> positions;      ///< X [m]
    std::vector<Vec3> displacements;  ///< d of the running step [m]
    std::vector<Vec3> velocities;     ///< v [m/s]
    /// How far the skin at each vertex is folded, 0 to 1, as of unfoldAsReference(); else empty.
    std::vector<double> folds;
};

/// The body at rest, without motion.
ReferenceState restState(const BodyModel& model);

/// Plain position-based dynamics as in the paper, mass-splitting Jacobi per constraint type (Tonge
/// et al. 2012): the double-precision reference for its kernels. A step is, in this order: predict,
/// then per sweep the types of constraints (constraints.h), pulls, floor, then finish; each sweep
/// applies a share of the correction of rigid constraints. Phases are independent; constraints read
/// `positions + displacements` from the start of the phase and change displacements only.
class ReferenceSolver {
  public:
    /// `model` must outlive the solver.
    ReferenceSolver(const BodyModel& model, const shared::SolverUniforms& uniforms);

    /// w of a vertex [1/kg]; 0 for vertices that no force moves.
    double inverseMass(int vertex) const { return inverseMass_[vertex]; }
    /// 0 makes a vertex kinematic: it keeps its velocity.
    void setInverseMass(int vertex, double w) { inverseMass_[vertex] = w; }
    /// w of all vertices [1/kg].
    const std::vector<double>& inverseMasses() const { return inverseMass_; }

    /// Sets what hands hold.
    void setPulls(std::vector<shared::PullRecord> pulls) { pulls_ = std::move(pulls); }

    /// Does one time step: uniforms.sweeps sweeps.
    void step(ReferenceState& state) const;

    /// v += h g, d = h v; kinematic vertices: d = h v.
    void predict(ReferenceState& state) const;
    /// Does one Jacobi sweep over the constraints of a type.
    void solve(std::uint32_t type, ReferenceState& state) const;
    /// Moves the vertices that hands hold by an implicit, critically damped spring of rate
    /// kPullRate.
    void pull(ReferenceState& state) const;
    /// Lifts vertices onto the floor, those that start below it at no more than lift_speed;
    /// friction shortens their tangential displacement by at most friction * lift.
    void collideFloor(ReferenceState& state) const;
    /// v = d / h exp(-c h) (not for kinematic vertices), X += d, d = 0.
    void finish(ReferenceState& state) const;

    /// Current volume per piece at positions + displacements [m^3].
    std::vector<double> volumes(const ReferenceState& state) const;

  private:
    const BodyModel& model_;
    shared::SolverUniforms uniforms_;
    std::vector<double> inverseMass_;
    std::vector<shared::PullRecord> pulls_;
};

}  // namespace kerf

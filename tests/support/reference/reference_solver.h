#pragma once

#include <vector>

#include "shaders/shared/solver_uniforms.h"
#include "sim/body/body_model.h"

namespace kerf {

/// The state that the reference solver moves, shape [vertexCount]. Inside a substep a vertex is at
/// positions + displacements; constraints only use differences (X_i - X_j) + (d_i - d_j), so that
/// floats on the GPU don't lose momentum.
struct ReferenceState {
    std::vector<Vec3> positions;      ///< X [m]
    std::vector<Vec3> displacements;  ///< d of the running substep [m]
    std::vector<Vec3> velocities;     ///< v [m/s]
    /// How far the skin at each vertex is folded, 0 to 1, as of the last unfold(); empty before.
    std::vector<double> folds;

    double fold(std::size_t vertex) const { return folds.empty() ? 0.0 : folds[vertex]; }
};

/// The body at rest, without motion.
ReferenceState restState(const BodyModel& model);

/// XPBD with small steps and one iteration per substep (Macklin et al. 2019), mass-splitting Jacobi
/// per constraint type (Tonge et al. 2012): the plain double-precision reference for every kernel.
/// A substep is, in this order: unfold, predict, then per sweep the types of constraints
/// (constraints.h), volume, pulls, floor, then finish. Plain PBD is many sweeps in one substep,
/// each with a share of the correction of rigid constraints. Phases are independent; constraints
/// read `positions + displacements` from the start of the phase and change displacements only.
class ReferenceSolver {
  public:
    /// `model` must outlive the solver.
    ReferenceSolver(const BodyModel& model, const shared::SolverUniforms& uniforms);

    /// w of a vertex [1/kg]; 0 for vertices that no force moves.
    double inverseMass(int vertex) const { return inverseMass_[vertex]; }
    /// 0 makes a vertex kinematic: it keeps its velocity.
    void setInverseMass(int vertex, double w) { inverseMass_[vertex] = w; }
    /// Volume target of a piece = its rest volume + offset [m^3]; 0 unless set.
    void setVolumeOffset(int piece, double offset) { volumeOffset_[piece] = offset; }

    /// Sets what hands hold.
    void setPulls(std::vector<shared::PullRecord> pulls) { pulls_ = std::move(pulls); }

    /// Does one time step: uniforms.substeps substeps.
    void step(ReferenceState& state) const;
    void substep(ReferenceState& state) const;

    /// Unfolds folded skin to its rest shape; see Unfolding. Until the next call constraints there
    /// are hardly damped and the floor has no friction (shaders/sim/folds.glsl).
    void unfold(ReferenceState& state) const;
    /// v += h g, d = h v; kinematic vertices: d = h v.
    void predict(ReferenceState& state) const;
    /// Does one Jacobi sweep over the constraints of a type.
    void solve(std::uint32_t type, ReferenceState& state) const;
    /// Rigid volume constraint of each piece that holds one, about the mean of its vertices.
    void solveVolume(ReferenceState& state) const;
    /// Moves the vertices that hands hold by an implicit, critically damped spring of rate
    /// kPullRate.
    void pull(ReferenceState& state) const;
    /// Lifts vertices onto the floor, those that start below it at no more than lift_speed;
    /// friction shortens their tangential displacement by at most friction * lift.
    void collideFloor(ReferenceState& state) const;
    /// v = d / h exp(-c h) (not for kinematic vertices), X += d, d = 0.
    void finishSubstep(ReferenceState& state) const;

    /// Current volume per piece at positions + displacements [m^3].
    std::vector<double> volumes(const ReferenceState& state) const;

  private:
    const BodyModel& model_;
    shared::SolverUniforms uniforms_;
    std::vector<double> inverseMass_;
    std::vector<double> volumeOffset_;
    std::vector<shared::PullRecord> pulls_;
};

}  // namespace kerf

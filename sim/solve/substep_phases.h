#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "gpu/program.h"
#include "sim/solve/solver_body.h"

namespace kerf {

/// The phases of a substep except contact, in a dispatch or two each; each ends with a storage
/// barrier, and does nothing if its part of the uniforms is off.
class SubstepPhases {
  public:
    /// The body must outlive it. Compiles the kernels: throws gpu::ShaderError.
    explicit SubstepPhases(SolverBody& body);

    /// The folds of the skin at each vertex (Unfolding::folds()) in the coming substeps; null, the
    /// default, if not folded. The first folds compile kernels: throws gpu::ShaderError.
    void setFolds(const gpu::Buffer* folds);

    void predictAndStretch();
    /// Solves the edges without a prediction: in all sweeps except the first.
    void stretchAgain();
    /// Solves the constraints of a type other than edges.
    void solve(std::uint32_t type) { solve(type, gather_[type]); }
    /// Solves all except edges, and with `ontoFloor` the floor.
    void solveAll(bool ontoFloor);
    /// Whether only the floor may follow the last type in a sweep.
    bool mayGatherOntoFloor() const;
    void solveVolume();
    void pull();
    /// Between two sweeps of plain PBD.
    void collideFloor();
    /// The floor and the end of the substep.
    void finish();
    /// Volume, floor and finish in one, if nothing comes between them.
    void settle();

  private:
    /// By type of constraint, except edges.
    using ConstraintKernels = std::array<gpu::Program, kConstraintTypes>;
    /// Kernels for folded skin: shaders/sim/folds.glsl.
    struct FoldedKernels {
        gpu::Program stretch, floor, finish, settle;
        ConstraintKernels solve;
    };
    /// Index of the kernels for the present solver: 1 for plain PBD, else 0.
    std::size_t solverKind() const { return body_.plainPbd() ? 1 : 0; }
    /// Whether the skin is folded; then binds the folds, which the end of a substep forgets.
    bool bindFolds() const;
    void bindLists(std::uint32_t type) const;
    void solve(std::uint32_t type, const gpu::Program& gather);
    void sumVolume();

    SolverBody& body_;
    std::optional<FoldedKernels> foldedKernels_;
    const gpu::Buffer* folds_ = nullptr;
    gpu::Program stretch_;
    std::array<gpu::Program, 2> stretchAgain_;
    std::array<ConstraintKernels, 2> solve_;
    ConstraintKernels gather_;
    gpu::Program gatherOntoFloor_;  ///< the last type
    gpu::Program volumeGradient_, volumeCorrect_, pull_, floor_, finish_, settle_;
};

}  // namespace kerf

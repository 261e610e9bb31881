#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "gpu/program.h"
#include "sim/solve/solver_body.h"

namespace kerf {

/// The phases of a substep in a dispatch or two each, but for contact; each ends with a storage
/// barrier, and does nothing where its part of the uniforms is off.
class SubstepPhases {
  public:
    /// The body must outlive it. Compiles the kernels: throws gpu::ShaderError.
    explicit SubstepPhases(SolverBody& body);

    /// How far the skin at each vertex is folded (Unfolding::folds()) in the substeps to come; null
    /// where it is not folded, as at the start. At the first folds compiles kernels: throws
    /// gpu::ShaderError.
    void setFolds(const gpu::Buffer* folds);

    void predictAndStretch();
    /// Solves the edges without a prediction: in all sweeps but the first.
    void stretchAgain();
    void solveBends();
    void solveIspcs() { solveIspcs(gatherIspcs_); }
    /// ISPCs and the floor, where that is all that follows them in a sweep.
    void solveIspcsOntoFloor() { solveIspcs(gatherIspcsOntoFloor_); }
    bool mayGatherOntoFloor() const;
    void solveVolume();
    void pull();
    void collideFloor();
    void finish();
    /// Volume, floor and finish in one, where nothing comes between them.
    void settle();

  private:
    struct ConstraintKernels {
        gpu::Program stretchAgain, bend, ispc;
    };
    /// Kernels that act otherwise on folded skin: shaders/sim/folds.glsl.
    struct FoldedKernels {
        gpu::Program stretch, bend, ispc, floor, settle;
    };
    ConstraintKernels compileConstraints(bool plainPbd) const;
    const ConstraintKernels& constraints() const;
    /// `folded` instead of `kernel` where the skin is folded.
    const gpu::Program& choose(const gpu::Program& kernel,
                               gpu::Program FoldedKernels::*folded) const;
    void bindSpokes() const;
    void solveIspcs(const gpu::Program& gather);
    void runOverConstraints(const gpu::Program& kernel, std::uint32_t count);
    void sumVolume();

    SolverBody& body_;
    std::array<ConstraintKernels, 2> constraints_;  ///< for any solver, for plain PBD
    std::optional<FoldedKernels> foldedKernels_;
    const gpu::Buffer* folds_ = nullptr;
    gpu::Program stretch_, gatherBends_, gatherIspcs_, gatherIspcsOntoFloor_;
    gpu::Program volumeGradient_, volumeCorrect_, pull_, floor_, finish_, settle_;
};

}  // namespace kerf

#pragma once

#include <cstddef>

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "sim/solve/solver_body.h"

namespace kerf {

/// Brings a surface that is folded back, on the GPU: elastic forces alone leave triangles turned
/// over, as their edges have the right lengths again. Between two substeps the vertices around each
/// edge that is bent by more than 60 degrees from rest are drawn to how they lie at rest, by an
/// overdamped spring that changes no momentum, and is damped more, so that it holds against loads,
/// while no blade cuts. Where nothing is folded no bit changes.
class Unfolding {
  public:
    static constexpr int kDispatches = 5;

    /// Compiles the kernels. Throws gpu::ShaderError.
    Unfolding();
    /// A body of so many vertices. Throws gpu::OutOfMemory.
    void resize(std::size_t vertices);
    /// Changes velocities.
    void run(const SolverBody& body);
    /// How far the skin at each vertex is folded, 0 to 1, as of the last run: a float each.
    const gpu::Buffer& folds() const { return folds_; }

  private:
    void bind(const SolverBody& body) const;

    gpu::Program forgetFolds_, findFolds_, sumFolds_, findGoals_, unfold_;
    gpu::Buffer folds_, foldSums_, goals_;
};

}  // namespace kerf

#pragma once

#include <cstddef>

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "sim/solve/solver_body.h"

namespace kerf {

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

}  // namespace kerf

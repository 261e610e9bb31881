#pragma once

#include <span>

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "sim/solve/solver_body.h"

namespace kerf {

/// The positions of a body when a step ended, to which pieces go back that are lost in the next.
class SavedPieces {
  public:
    /// The body must outlive it. Compiles the kernel: throws gpu::ShaderError.
    explicit SavedPieces(SolverBody& body);

    /// Remembers the positions on the GPU.
    void save() { body_.state.saved.copyFrom(body_.state.positions); }
    /// Brings those of some pieces back, with velocities at zero.
    void restoreAtRest(std::span<const int> pieces);

  private:
    SolverBody& body_;
    gpu::Program kernel_;
    gpu::Buffer marks_;  ///< per piece
};

}  // namespace kerf

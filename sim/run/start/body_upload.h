#pragma once

#include <memory>

#include "sim/body/body_model.h"
#include "sim/run/start/prepared_body.h"
#include "sim/solve/gpu_solver.h"

namespace kerf {

/// The upload of a prepared body to the GPU, in portions, so that frames can be drawn in between.
/// Then a Simulation takes it over.
class BodyUpload {
  public:
    /// Compiles the kernels for the OpenGL context that is current. Throws gpu::ShaderError.
    explicit BodyUpload(PreparedBody prepared);

    bool done() const { return next_ == GpuSolver::kModelPortions; }
    /// Uploads the next portion; not once it is done. Throws gpu::OutOfMemory.
    void advance();
    void finish();

  private:
    friend class Simulation;

    PreparedBody prepared_;
    BodyState state_;
    std::unique_ptr<GpuSolver> solver_;
    int next_ = 0;
};

}  // namespace kerf

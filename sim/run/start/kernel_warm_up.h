#pragma once

#include "sim/base/math.h"
#include "sim/base/params.h"
#include "sim/body/body_model.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/solve/gpu_solver.h"

namespace kerf {

/// Two boxes of a metre, one above the other, that overlap a little and approach each other: a body
/// that needs the kernels of contact.
SurfaceMesh touchingBoxes();
BodyState approachingStateOf(const SurfaceMesh& touchingBoxes);
/// Around their velocities [m/s].
Bounds approachingVelocities();

/// Runs the kernels of a stroke, a fall, a contact and a pull on a tiny body, one at a time:
/// software drivers compile with the first dispatch, which should not delay a stroke. It works
/// where programs are shared (gpu::ProgramShelf), during its lifetime.
class KernelWarmUp {
  public:
    /// For bodies with these parameters. Throws gpu::ShaderError, gpu::OutOfMemory.
    explicit KernelWarmUp(Params params);

    /// Runs one more of the kernels for the first time. Returns false once all have run.
    bool advance();

  private:
    /// The motion of the tiny body in a step.
    enum class Act { touch, fold, pull, done };
    void expect();

    GpuSolver solver_;
    BodyState start_;
    Act act_ = Act::touch;
};

}  // namespace kerf

#pragma once

#include "sim/base/params.h"
#include "sim/solve/gpu_solver.h"
#include "tests/support/reference/reference_solver.h"

namespace kerf {

/// A body, displaced from rest and in motion, on the GPU and in double precision, from the same
/// floats, to compare the two solvers.
struct SolverPair {
    /// `parts`: of SolverUniforms::active_parts. `shake`: how far from rest [edge lengths].
    /// Throws gpu::ShaderError, gpu::OutOfMemory.
    SolverPair(const SurfaceMesh& mesh, const Params& params, shared::uint parts, unsigned seed,
               float shake = 0.05f);

    /// Largest difference between the displacements of the two solvers [m].
    double error() const;
    /// Largest difference between their positions, between substeps [m].
    double positionError() const;
    /// Largest change of a displacement of the reference since `before` [m].
    double change(const std::vector<Vec3>& before) const;

    BodyModel model;
    shared::SolverUniforms uniforms;
    BodyState start;
    ReferenceState reference;
    GpuSolver gpu;
};

}  // namespace kerf

#pragma once

#include <cstdint>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "shaders/shared/body_records.h"
#include "shaders/shared/solver_uniforms.h"
#include "sim/solve/scatter.h"
#include "sim/solve/solver_model.h"
#include "sim/solve/solver_pieces.h"
#include "sim/solve/solver_state.h"

namespace kerf {

/// A body on the GPU, as the solver's kernels see it: constant set-up, running state, parameters.
struct SolverBody {
    SolverBody();

    /// Takes the parameters of `parameters`; its counts, and how firmly it unfolds, are ignored.
    void setParameters(const shared::SolverUniforms& parameters);
    void setCountsOf(const BodyModel& of);
    /// See GpuSolver.
    void unfoldFirmly(bool firmly);
    void setPulls(const std::vector<shared::PullRecord>& records);

    bool active(shared::uint part) const { return (uniforms.active_parts & part) != 0; }
    /// Nothing is damped or gives way, so that kernels compiled for it give the same bits.
    bool plainPbd() const;
    /// Binds what most kernels read.
    void bind() const;
    /// Binds a buffer that kernels fetch: as texels and, where loadsImages, as an image.
    void bindFetched(const gpu::Buffer& buffer, std::uint32_t binding,
                     gpu::TexelFormat format) const;
    /// Runs a kernel with so many threads, and counts it.
    void run(const gpu::Program& kernel, std::uint32_t threads);
    /// Runs one group for each block, of the vertices on its pages.
    void runOverBlocks(const gpu::Program& kernel);

    const bool loadsImages;  ///< on llvmpipe, see fetch.glsl
    SolverModel model;
    SolverPieces pieces;
    SolverState state;
    shared::SolverUniforms uniforms{};
    gpu::Buffer uniformBuffer, pulls;
    Scatter scatter;
    long dispatches = 0;  ///< kernels started so far

  private:
    void uploadUniforms();
};

}  // namespace kerf

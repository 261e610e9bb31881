#pragma once

#include "gpu/buffer.h"
#include "gpu/kernel_way.h"
#include "gpu/program.h"
#include "gpu/read_back.h"
#include "shaders/shared/body_records.h"
#include "shaders/shared/solver_uniforms.h"
#include "sim/body/body_model.h"
#include "sim/solve/scatter.h"
#include "sim/solve/solver_model.h"
#include "sim/solve/solver_pieces.h"

namespace kerf {

/// The numbers on the GPU that a step changes: base positions X with inverse unit masses,
/// velocities, and the displacement d of a substep. All that allocates throws gpu::OutOfMemory.
struct SolverState {
    gpu::Buffer positions, velocities, displacement;
    gpu::Buffer previous;  ///< d before the last sweep
    gpu::Buffer saved;     ///< X when the last step ended
    gpu::Buffer gradients, corrections;
    gpu::Buffer courses;  ///< of pieces: how iterations went; empty before implicit steps

    /// Allocates the substep state of such a body.
    void makeRoom(const BodyModel& model);
    /// Takes over all positions and velocities.
    void assign(const BodyState& state);
    /// Writes the state of `written` (ascending), also where X is saved; there are `count`
    /// vertices.
    void update(std::span<const std::uint32_t> written, const BodyState& state, std::size_t count,
                Scatter& scatter);
    /// The places of the state in a read-back.
    struct Offsets {
        std::size_t positions = 0;
        std::size_t velocities = 0;
        std::size_t count = 0;  ///< of vertices
    };
    /// Requests the state of `count` vertices.
    Offsets askFor(gpu::ReadBack& back, std::size_t count) const;
    /// The requested state; waits for the GPU.
    static BodyState take(const gpu::ReadBack& back, const Offsets& at);
    /// Reads the state of `count` vertices back; waits for the GPU.
    BodyState read(std::size_t count) const;

  private:
    mutable gpu::ReadBack back_;
};

/// A body on the GPU for the solver's kernels: constant set-up, running state, parameters.
struct SolverBody {
    SolverBody();

    /// Takes `parameters`; ignores its counts and how firmly it unfolds.
    void setParameters(const shared::SolverUniforms& parameters);
    void setCountsOf(const BodyModel& of);
    /// See GpuSolver.
    void unfoldFirmly(bool firmly);
    void setPulls(const std::vector<shared::PullRecord>& records);

    bool active(shared::uint part) const { return (uniforms.active_parts & part) != 0; }
    /// Binds what most kernels read.
    void bind() const;
    /// Binds a buffer that kernels fetch: as texels and, for that way, as an image.
    void bindFetched(const gpu::Buffer& buffer, std::uint32_t binding,
                     gpu::TexelFormat format) const;
    /// The groups of kernels that sum over blocks: llvmpipe resumes a coroutine at each barrier for
    /// every eight threads of a group, so that its groups are small.
    gpu::Defines groupsOfSums() const {
        return {{"SUM_GROUP",
                 std::to_string(way == gpu::KernelWay::images ? 8 : shared::kPageSize) + "u"}};
    }
    /// Compiles sim/NAME.comp, whose fetches are those of fetch.glsl.
    gpu::Program compile(const std::string& name, gpu::Defines defines = {}) const;
    /// Runs a kernel with `threads` threads, and counts it.
    void run(const gpu::Program& kernel, std::uint32_t threads);
    /// Runs one group for each block, of the vertices on its pages.
    void runOverBlocks(const gpu::Program& kernel);

    const gpu::KernelWay way;  ///< see fetch.glsl
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

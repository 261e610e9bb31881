#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/read_back.h"
#include "sim/body/body_model.h"
#include "sim/body/body_state.h"
#include "sim/solve/scatter.h"

namespace kerf {

/// The numbers on the GPU that a step changes: base positions X with inverse unit masses,
/// velocities, and the displacement d of a substep. All that allocates throws gpu::OutOfMemory.
struct SolverState {
    gpu::Buffer positions, velocities, displacement;
    gpu::Buffer previous;  ///< d before the last sweep
    gpu::Buffer saved;     ///< X when the last step ended
    gpu::Buffer gradients, corrections;

    /// Makes room for what a substep keeps of such a body.
    void makeRoom(const BodyModel& model);
    /// Takes over all positions and velocities.
    void assign(const BodyState& state);
    /// Writes the state of `written` (ascending), also where X is saved; there are `count`
    /// vertices.
    void update(std::span<const std::uint32_t> written, const BodyState& state, std::size_t count,
                Scatter& scatter);
    /// Where the state lies in what was asked for.
    struct Places {
        std::size_t positions = 0;
        std::size_t velocities = 0;
        std::size_t count = 0;  ///< of vertices
    };
    /// Asks for the state of `count` vertices.
    Places askFor(gpu::ReadBack& back, std::size_t count) const;
    /// The state that was sent; waits for the GPU.
    static BodyState take(const gpu::ReadBack& back, const Places& places);
    /// Reads the state of `count` vertices back; waits for the GPU.
    BodyState read(std::size_t count) const;

  private:
    mutable gpu::ReadBack back_;
};

}  // namespace kerf

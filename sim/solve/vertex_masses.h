#pragma once

#include "gpu/program.h"
#include "sim/base/math.h"
#include "sim/solve/solver_body.h"

namespace kerf {

/// The inverse unit masses of a body's vertices: which move under forces, are fixed, or have a
/// prescribed velocity.
class VertexMasses {
  public:
    /// The body must outlive it. Compiles the kernel: throws gpu::ShaderError.
    explicit VertexMasses(SolverBody& body);

    /// Computes the masses now.
    void compute();
    /// Makes the next step recompute the masses, since it visits every vertex anyway: a cut changes
    /// all masses of a piece.
    void invalidate() { stale_ = true; }
    void refresh();

    /// Prescribes the velocity of a vertex until released.
    void anchor(int vertex, const Vec3f& velocity);
    void release(int vertex);
    /// Prescribes the velocities of massless vertices (ascending) in the coming step [m/s].
    void carry(std::span<const std::uint32_t> vertices, std::span<const Vec3f> velocities);
    /// Puts massless vertices (ascending) at places [m], from which they move with these velocities
    /// [m/s] until the next refresh().
    void carryFrom(std::span<const std::uint32_t> vertices, std::span<const Vec3f> places,
                   std::span<const Vec3f> velocities);
    /// Sets the fixed vertices, ascending, from the next refresh() on.
    void setPinned(std::vector<std::uint32_t> vertices);
    /// Whether any velocity was prescribed since the last call.
    bool takeCarries() { return std::exchange(carries_, false); }
    /// Unpins all vertices: of a new body, whose masses are computed later.
    void freeAll() { pinned_.clear(); }

  private:
    bool isPinned(int vertex) const {
        return std::ranges::binary_search(pinned_, static_cast<std::uint32_t>(vertex));
    }
    void holdPinned();
    void setInverse(int vertex, float value);

    SolverBody& body_;
    gpu::Program kernel_;
    std::vector<std::uint32_t> pinned_;  ///< ascending
    bool stale_ = false;
    bool carries_ = false;
};

}  // namespace kerf

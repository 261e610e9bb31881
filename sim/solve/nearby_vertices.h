#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/read_back.h"
#include "shaders/shared/body_records.h"
#include "sim/mesh/oriented_box.h"

namespace kerf {

/// Positions and velocities of some vertices, each once, ascending.
struct VertexStates {
    std::vector<shared::NearbyVertex> records;
    /// Whether all that were asked for are there; otherwise those near the box were too many.
    bool complete = true;
};

/// A question of the CPU for vertices on the GPU, and a buffer for the answer.
class NearbyVertices {
  public:
    NearbyVertices();

    /// The vertices of all triangles that meet `box` (none: no such), and those `asked` for by
    /// number.
    void ask(const std::optional<OrientedBox>& box, std::span<const int> asked);
    /// The query as it was asked, without what was answered to it before.
    void renew();
    /// Whether there is a query at all.
    bool asks() const { return query_.asks_for_box != 0 || query_.asked_vertices > 0; }
    /// How many were asked for by number.
    std::uint32_t asked() const { return query_.asked_vertices; }
    void bind() const;
    /// Asks for the answer, as far as it is expected to reach; the kernels were told before.
    void askFor(gpu::ReadBack& back);
    /// The answer that was sent; waits for the GPU, and reads once more where it is longer than was
    /// expected. Ends the query.
    VertexStates take(const gpu::ReadBack& back);

  private:
    shared::NearbyQuery query_{};
    gpu::Buffer buffer_;
    /// How long the answer for the next box may be: somewhat longer than the last one.
    std::uint32_t expected_ = kLeastExpected;
    std::uint32_t sent_ = 0;  ///< records of the answer that were asked for
    std::size_t place_ = 0;   ///< of the answer
    static constexpr std::uint32_t kLeastExpected = 4096;
};

}  // namespace kerf

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
    /// Whether it is complete; otherwise there were too many near the box.
    bool complete = true;
};

/// A query of the CPU for vertices on the GPU, and a buffer for the result.
class NearbyVertices {
  public:
    NearbyVertices();

    /// Queries the vertices of all triangles that meet `box`, if any, and those in `asked`.
    void ask(const std::optional<OrientedBox>& box, std::span<const int> asked);
    /// Repeats the query, without previous results.
    void renew();
    /// Whether there is a query at all.
    bool asks() const { return query_.asks_for_box != 0 || query_.asked_vertices > 0; }
    /// The number of vertices in `asked`.
    std::uint32_t asked() const { return query_.asked_vertices; }
    void bind() const;
    /// Requests the result in its expected size; the kernels have the query already.
    void askFor(gpu::ReadBack& back);
    /// The result; waits for the GPU, and reads again if it is longer than expected. Ends the
    /// query.
    VertexStates take(const gpu::ReadBack& back);

  private:
    shared::NearbyQuery query_{};
    gpu::Buffer buffer_;
    /// Expected size of the next result: somewhat longer than the last one.
    std::uint32_t expected_ = kLeastExpected;
    std::uint32_t sent_ = 0;  ///< requested records of the result
    std::size_t place_ = 0;   ///< of the result
    static constexpr std::uint32_t kLeastExpected = 4096;
};

}  // namespace kerf

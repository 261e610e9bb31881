#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "gpu/buffer.h"
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
    /// The answer; waits for the GPU. Ends the query.
    VertexStates take();

  private:
    std::vector<shared::NearbyVertex> read(std::size_t first, std::size_t count) const;

    shared::NearbyQuery query_{};
    gpu::Buffer buffer_;
    /// How long the next answer may be: about as long as the last one, so that one read has it all.
    std::uint32_t expected_ = 0;
};

}  // namespace kerf

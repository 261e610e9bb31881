#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <vector>

#include "sim/base/region.h"
#include "sim/cut/cut_types.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// Fixed vertices.
class Pins {
  public:
    /// Pins the free vertices in the region, or unpins the pinned ones. Returns how many.
    int change(const Region& region, bool pinned, const SurfaceMesh& mesh);
    /// After a step of the cut: removes dead vertices, and pins copies of pinned ones. Returns
    /// whether anything changed.
    bool follow(const SurfaceMesh& mesh, const CutDelta& delta);

    /// Ascending.
    const std::vector<std::uint32_t>& vertices() const { return vertices_; }

    /// Writes or reads all of it (ByteArchive).
    template <class Archive>
    void archive(Archive& io) {
        io(vertices_, positions_);
    }

  private:
    using RestPosition = std::array<double, 3>;
    static RestPosition restPositionOf(const SurfaceMesh& mesh, std::uint32_t vertex);
    void collectPlaces(const SurfaceMesh& mesh);
    bool holds(int vertex) const;

    std::vector<std::uint32_t> vertices_;
    std::set<RestPosition>
        positions_;  ///< rest positions of the vertices: copies share them, bit for bit
};

}  // namespace kerf

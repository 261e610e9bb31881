#pragma once

#include <span>
#include <vector>

#include "sim/base/math.h"
#include "sim/mesh/oriented_box.h"

namespace kerf {

/// Finds the living triangles of a mesh by their current position, while it is cut.
class TriangleFinder {
  public:
    TriangleFinder() = default;
    virtual ~TriangleFinder() = default;
    TriangleFinder(const TriangleFinder&) = default;
    TriangleFinder& operator=(const TriangleFinder&) = default;

    /// Triangles that may meet `box`; none that does is missing. Ascending.
    virtual std::vector<int> near(const OrientedBox& box) = 0;
    /// A box that holds all triangles; it may be larger than needed.
    virtual Bounds bounds() = 0;
    /// Follows a change of the mesh. `triangles`: the slots that were added or removed, or of which
    /// a corner changed; each once.
    virtual void update(std::span<const int> triangles) = 0;
};

}  // namespace kerf

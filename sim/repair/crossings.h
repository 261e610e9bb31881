#pragma once

#include "sim/mesh/triangle_soup.h"

namespace kerf::repair {

/// At most `most` intersecting pairs of triangles of a welded soup, the lower first, ascending.
/// Exact. Edges and faces that only touch don't count; where they meet along a line, the faces
/// beside it decide, and faces with their material on the same side intersect. `parts`: of each
/// triangle, to find only pairs of different parts. O(n log n + pairs).
std::vector<std::pair<int, int>> findCrossings(const TriangleSoup& welded, std::size_t most,
                                               const std::vector<int>* parts = nullptr);

/// The intersecting triangles, ascending; of models with very many not all.
std::vector<int> crossingTriangles(const TriangleSoup& welded);

}  // namespace kerf::repair

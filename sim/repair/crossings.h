#pragma once

#include <utility>
#include <vector>

#include "sim/mesh/triangle_soup.h"

namespace kerf::repair {

/// Pairs of triangles of a welded soup where its surface passes through itself, the lower first,
/// ascending; so many at most. Signs are exact. Where edges and faces only touch, there is none;
/// where they meet along a line, the faces beside it tell, and faces with their material on the
/// same side pass through each other. `parts`: of each triangle, to look for pairs of different
/// parts alone. O(n log n), and what is found.
std::vector<std::pair<int, int>> findCrossings(const TriangleSoup& welded, std::size_t most,
                                               const std::vector<int>* parts = nullptr);

/// The triangles that pass through others, ascending; of models that cross through and through not
/// all.
std::vector<int> crossingTriangles(const TriangleSoup& welded);

}  // namespace kerf::repair

#pragma once

#include <utility>
#include <vector>

#include "sim/mesh/triangle_soup.h"

namespace kerf::repair {

/// Pairs of triangles of a welded soup that pass through each other, the lower first, ascending; so
/// many at most. Signs are exact. Triangles that only touch don't count. O(n log n), and what is
/// found.
std::vector<std::pair<int, int>> findCrossings(const TriangleSoup& welded, std::size_t most);

/// The triangles that pass through others, ascending; of models that cross through and through not
/// all.
std::vector<int> crossingTriangles(const TriangleSoup& welded);

/// Notes in a report how many those are.
void countCrossings(const TriangleSoup& welded, MeshReport& report);

}  // namespace kerf::repair

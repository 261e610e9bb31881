#pragma once

#include <vector>

#include "sim/mesh/triangle_soup.h"

namespace kerf::repair {

/// The shells of a soup: parts connected by common vertices, numbered by their lowest triangles.
struct SoupShells {
    std::vector<int> ofTriangle;
    std::vector<double> volumes;  ///< signed [m^3]
    std::vector<double> areas;    ///< [m^2]
    std::vector<Bounds> bounds;   ///< [m]
    std::vector<int> firsts;      ///< the lowest triangle
    std::vector<int> counts;      ///< of triangles

    /// How many there are.
    int size() const { return static_cast<int>(volumes.size()); }
};

/// Measures all shells. Triangles must be proper. Volumes are summed about `middle`, where rounding
/// is smallest. O(n).
SoupShells measureShells(const TriangleSoup& soup, const Vec3& middle);

/// By shell: in how many others it lies as a whole, as far as samples tell. A shell lies in none
/// that it crosses, and shells around it that cross each other count as one, as a union would make
/// them. The soup must be closed, manifold and consistently oriented. O(n log n), and O(n) for each
/// sample.
std::vector<int> nestingDepths(const TriangleSoup& soup, const SoupShells& shells);

}  // namespace kerf::repair

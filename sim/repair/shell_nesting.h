#pragma once

#include "sim/mesh/triangle_soup.h"

namespace kerf::repair {

/// The shells of a soup: parts connected by common vertices, numbered by their lowest triangles.
struct SoupShells {
    std::vector<int> ofTriangle;
    std::vector<double> volumes;  ///< signed [m^3]
    std::vector<double> areas;    ///< [m^2]
    std::vector<Bounds> bounds;   ///< [m]
    Vec3 origin = Vec3::Zero();   ///< see floatOrigin()

    /// How many there are.
    int size() const { return static_cast<int>(volumes.size()); }
    /// Whether shell a encloses more than b. Ties: the one that faces inwards, else the first.
    bool isLarger(int a, int b) const;
    /// Whether a closed shell encloses no more than the rounding error of 32-bit floats.
    bool isFlat(int shell) const;
};

/// Measures all shells. Triangles must be proper. O(n).
SoupShells measureShells(const TriangleSoup& soup);

/// What each shell bounds.
struct ShellNesting {
    std::vector<char> cavity;  ///< by shell: 1 where it is a hollow in another one
    std::vector<int> owner;  ///< the shell of material that a cavity lies in; of others themselves
};

/// Finds which shells bound material from outside and which bound cavities. A shell that crosses
/// none is a cavity if it is inside material. For one that crosses others, its orientation decides
/// where both are possible: a rib sunk into the wall of a cavity is material, and two cavities may
/// cross. The soup must be closed, manifold and consistently oriented; shells may be inside out.
/// O(n log n).
ShellNesting nestShells(const TriangleSoup& soup, const SoupShells& shells);

}  // namespace kerf::repair

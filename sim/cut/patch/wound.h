#pragma once

#include <vector>

#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// An edge of the loop around a wound, as half-edges of absent walls: u -> v on W+, and its mirror
/// v' -> u' on W-. Their twins are present.
struct WoundEdge {
    int plus = -1;
    int minus = -1;
};

/// A sheet of wall that a stroke of the open course left absent, and the loops in which it meets
/// the body's surface; the sheet lies on the left of W+.
struct Wound {
    std::vector<int> plus;   ///< triangles of W+, ascending
    std::vector<int> minus;  ///< their mirrors
    std::vector<std::vector<WoundEdge>> loops;
    /// The stroke ended in the body: where it did the sheet has an edge that no surface borders.
    bool endsInside = false;
    /// Some triangle or edge of W+ has no mirror on W-.
    bool unmirrored = false;
};

/// All wounds of the open stroke, by their lowest triangle.
std::vector<Wound> findWounds(const SurfaceMesh& mesh);

}  // namespace kerf::cut

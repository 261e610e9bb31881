#pragma once

#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// An edge of the loop around a wound, as half-edges of absent walls: u -> v on W+, and its mirror
/// v' -> u' on W-. Their twins are present.
struct WoundEdge {
    int plus = -1;   ///< the half-edge on W+
    int minus = -1;  ///< the half-edge on W-
};

/// A sheet of wall that a stroke of the open cut left absent, and its border loops on the body's
/// surface; the sheet is on the left of W+.
struct Wound {
    std::vector<int> plus;                      ///< triangles of W+, ascending
    std::vector<int> minus;                     ///< their mirrors, in the same order
    std::vector<std::vector<WoundEdge>> loops;  ///< around the sheet, each closed
    /// Whether the stroke ended in the body: there the sheet has an edge without surface beside it.
    bool endsInside = false;
    /// Whether some triangle or edge of W+ has no mirror on W-.
    bool unmirrored = false;
};

/// Finds all wounds of the open stroke, ordered by their lowest triangle.
std::vector<Wound> findWounds(const SurfaceMesh& mesh);

}  // namespace kerf::cut

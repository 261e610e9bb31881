#pragma once

#include <array>
#include <vector>

#include "sim/mesh/triangle_soup.h"
#include "sim/repair/soup_inspection.h"

namespace kerf::repair {

/// What may be wrong with a model at one of its edges, vertices or triangles.
enum class FaultKind {
    openEdge,          ///< has one triangle: the border of a hole or of a sheet
    branchingEdge,     ///< has more than two
    touchingVertex,    ///< the surface touches itself there: more than one umbrella
    opposedEdge,       ///< its two triangles face opposite ways
    flatTriangle,      ///< has no area
    doubleTriangle,    ///< has the corners of one before it
    crossingTriangle,  ///< passes through another one
    needle,            ///< see isNeedle()
};
inline constexpr int kFaultKinds = 8;

/// Where one kind of fault is: edges, vertices or triangles, whichever has it, ascending.
struct FaultPlaces {
    std::vector<SurfaceFaults::Edge> edges;
    std::vector<int> vertices;
    std::vector<int> triangles;

    int count() const {
        return static_cast<int>(edges.size() + vertices.size() + triangles.size());
    }
};

/// The faults of a model by kind.
struct Faults {
    std::array<FaultPlaces, kFaultKinds> places;

    FaultPlaces& of(FaultKind kind) { return places[static_cast<std::size_t>(kind)]; }
    const FaultPlaces& of(FaultKind kind) const { return places[static_cast<std::size_t>(kind)]; }
    bool any() const;
};

/// Finds all faults of a welded soup; those that a MeshReport counts are the same. Triangles with
/// bad indices, and such at a vertex that is not finite, are left out. Without `crossings`, which
/// take the longest, no triangle is looked through for others.
Faults findFaults(const TriangleSoup& welded, bool crossings = true);

}  // namespace kerf::repair

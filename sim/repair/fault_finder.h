#pragma once

#include "sim/mesh/triangle_soup.h"
#include "sim/repair/soup_inspection.h"

namespace kerf::repair {

/// A fault of a model at an edge, vertex or triangle.
enum class FaultKind {
    openEdge,          ///< has one triangle: the border of a hole or of a sheet
    branchingEdge,     ///< has more than two
    touchingVertex,    ///< the surface touches itself there: more than one umbrella
    opposedEdge,       ///< its two triangles face opposite ways
    flatTriangle,      ///< has no area
    doubleTriangle,    ///< has the corners of an earlier one
    crossingTriangle,  ///< intersects another one
    needle,            ///< see isNeedle()
};
inline constexpr int kFaultKinds = 8;

/// The edges, vertices or triangles with one kind of fault, ascending.
struct FaultLocations {
    std::vector<SurfaceFaults::Edge> edges;
    std::vector<int> vertices;
    std::vector<int> triangles;

    int count() const {
        return static_cast<int>(edges.size() + vertices.size() + triangles.size());
    }
    template <class Io>
    void archive(Io& io) {
        io(edges, vertices, triangles);
    }
};

/// The faults of a model by kind.
struct Faults {
    std::array<FaultLocations, kFaultKinds> places;

    FaultLocations& of(FaultKind kind) { return places[static_cast<std::size_t>(kind)]; }
    const FaultLocations& of(FaultKind kind) const {
        return places[static_cast<std::size_t>(kind)];
    }
    bool any() const;
    template <class Io>
    void archive(Io& io) {
        io(places);
    }
};

/// Finds all faults of a welded soup; those that a MeshReport counts are the same. Triangles with
/// bad indices or non-finite vertices are skipped. Without `crossings`, which take the longest,
/// intersections are not searched.
Faults findFaults(const TriangleSoup& welded, bool crossings = true);

}  // namespace kerf::repair

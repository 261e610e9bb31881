#pragma once

#include "sim/mesh/triangle_soup.h"

namespace kerf {

/// A report on a model and whether it can be cut.
struct MeshReport {
    int vertices = 0;
    int triangles = 0;
    Bounds bounds;
    int pieces = 0;               ///< a shell that bounds a cavity belongs to the one around it
    double volume = 0;            ///< signed [m^3]
    int openEdges = 0;            ///< edges with one triangle
    int nonManifoldEdges = 0;     ///< edges with more than two
    int misorientedEdges = 0;     ///< edges whose two triangles run the same way
    int nonManifoldVertices = 0;  ///< vertices whose triangles form more than one umbrella
    int degenerateTriangles = 0;  ///< with a repeated corner or exactly zero area
    int nonFiniteVertices = 0;
    int outOfRangeIndices = 0;  ///< triangles that name a vertex that is not there
    int insideOutPieces = 0;    ///< closed shells of material that face inwards; see turnOutward
    int flatPieces = 0;         ///< closed pieces that enclose no volume
    int cavities = 0;           ///< closed shells that bound a hollow inside another one
    int outwardCavities = 0;    ///< of these: those that face outward; see turnOutward
    int crossingTriangles = 0;  ///< that intersect others; see countCrossings
    bool closed = false;
    bool manifold = false;
    /// Consistently, and, where it is closed and manifold, outward (positive volume).
    bool oriented = false;
    std::vector<std::string> repairs;  ///< what was changed, one phrase each
    std::vector<std::string> left;     ///< what a repair could not fix and why, a clause each
    bool cuttable = false;
    /// Empty if cuttable; else what is wrong, how often, and what to do.
    std::string problem;

    template <class Io>
    void archive(Io& io) {
        io(vertices, triangles, bounds, pieces, volume, openEdges, nonManifoldEdges,
           misorientedEdges, nonManifoldVertices, degenerateTriangles, nonFiniteVertices,
           outOfRangeIndices, insideOutPieces, flatPieces, cavities, outwardCavities,
           crossingTriangles, closed, manifold, oriented, repairs, left, cuttable, problem);
    }
};

/// Where a surface is broken.
struct SurfaceFaults {
    using Edge = std::array<int, 2>;     ///< its two vertices, the lower first
    std::vector<Edge> openEdges;         ///< see MeshReport, as of the others
    std::vector<Edge> nonManifoldEdges;  ///< each once
    std::vector<Edge> misorientedEdges;
    std::vector<int> nonManifoldVertices;
    std::vector<int> degenerateTriangles;
};

/// Finds the faults that inspectTriangles() counts, each list ascending. Skips triangles with bad
/// indices.
SurfaceFaults findSurfaceFaults(const TriangleSoup& welded);

/// Inspects a welded soup. Never throws. Triangles with bad indices or repeated corners are counted
/// and otherwise skipped.
MeshReport inspectTriangles(const TriangleSoup& welded);

/// Reverses shells with the wrong orientation: an outermost one faces outward, one inside it faces
/// inwards and bounds a cavity, one inside that faces outward again. The soup must be closed,
/// manifold and consistently oriented. Returns the number of shells reversed.
int turnOutward(TriangleSoup& soup);

/// Adds the number of intersecting triangles to a report; see repair::crossingTriangles().
void countCrossings(const TriangleSoup& welded, MeshReport& report);

}  // namespace kerf

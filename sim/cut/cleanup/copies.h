#pragma once

#include "sim/cut/wall_copies.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

// Cuts make copies of vertices. A vertex with its copies is one point of the uncut body, named by
// the first of them (SurfaceMesh::firstCopy). An edge or star is *shared* where it is taken between
// such points: with all its copies, in the mesh as if all slits were closed.

/// The line or face of a shared edge. The last three are features, which are preserved.
enum class SharedEdgeType {
    skin,      ///< inside the skin
    wall,      ///< inside a wall
    tip,       ///< the end of a slit inside the body
    rim,       ///< the line where walls meet the skin
    crossing,  ///< the line where walls of several cuts meet
};

/// An edge with all its copies, seen from one end.
struct SharedEdge {
    /// A triangle beside the edge, one for all equal copies.
    struct Face {
        int apex;    ///< first copy of the apex
        int stroke;  ///< the stroke that made the wall, -1 for skin
        bool operator==(const Face&) const = default;
    };
    int neighbour = -1;       ///< first copy of the other end
    std::vector<Face> faces;  ///< all faces beside the edge, each once

    /// The line or face that the edge is part of, from its faces.
    SharedEdgeType type() const;
    /// Whether the edge is on a line that must be preserved.
    bool isFeature() const { return type() >= SharedEdgeType::tip; }
    /// Whether some face has the apex `point`, a first copy.
    bool hasApex(int point) const;
};

/// A vertex with all its copies, and all edges around them: the mesh as if all slits were closed.
/// An operation that is valid here and done on all copies alike keeps walls mirrored.
struct SharedStar {
    int point = -1;                 ///< the first copy, which may be dead
    std::vector<int> copies;        ///< the living vertices
    std::vector<SharedEdge> edges;  ///< one to each neighbour

    /// The edge to the first copy `neighbour`, null where there is none.
    const SharedEdge* edgeTo(int neighbour) const;
    /// The number of edges that are features.
    int featureCount() const;
    /// Whether features meet here otherwise than as one smooth line.
    bool isCorner() const;
};

/// The shared star of a vertex.
SharedStar starOf(const SurfaceMesh& mesh, int vertex);

}  // namespace kerf::cut

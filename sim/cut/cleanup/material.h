#pragma once

#include <vector>

#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// What a material edge is part of. The last three are features: lines that must stay.
enum class MaterialEdgeType {
    skin,      ///< inside the skin
    wall,      ///< inside a wall
    tip,       ///< end of a slit inside the body
    rim,       ///< where walls meet the skin
    crossing,  ///< where walls of several cuts meet
};

/// All copies of an edge, seen from one end.
struct MaterialEdge {
    struct Side {
        int apex;   ///< material point opposite to the edge
        int sheet;  ///< stroke that made the wall beside it, -1 for skin
        bool operator==(const Side&) const = default;
    };
    int neighbour = -1;  ///< material point at the other end
    std::vector<Side> sides;

    MaterialEdgeType type() const;
    bool isFeature() const { return type() >= MaterialEdgeType::tip; }
    bool hasApex(int point) const;
};

/// A material point with all that surrounds it: the mesh as if all slits were closed. An operation
/// that is sound here and done on all copies alike keeps walls mirrored.
struct MaterialStar {
    int point = -1;
    std::vector<int> copies;  ///< living vertices
    std::vector<MaterialEdge> edges;

    const MaterialEdge* edgeTo(int neighbour) const;
    int featureCount() const;
    /// Features meet here in another way than as one smooth line.
    bool isCorner() const;
};

MaterialStar starOf(const SurfaceMesh& mesh, int vertex);

/// Living copies of the vertex's material point; the vertex itself where it has none.
std::vector<int> livingCopies(const SurfaceMesh& mesh, int vertex);

}  // namespace kerf::cut

#pragma once

#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// Every function here returns "" where the invariant holds, else one sentence with the first
/// place that breaks it. O(n); called by tests, by `closed` in the metrics and by debug switches.

/// (I1) Every half-edge has a twin with reversed end points, and twins are mutual.
std::string checkTwins(const SurfaceMesh& mesh);
/// (I2) The triangles around each vertex form one umbrella.
std::string checkUmbrellas(const SurfaceMesh& mesh);
/// (I3) No two edges have the same end points.
std::string checkSimpleComplex(const SurfaceMesh& mesh);
/// (I6) Positions, rest positions and velocities are finite.
std::string checkFinite(const SurfaceMesh& mesh);
/// (I1), (I2), (I3) and (I6): the mesh is a closed, oriented 2-manifold with finite coordinates.
std::string checkClosedManifold(const SurfaceMesh& mesh);
/// checkClosedManifold() around some triangles, at the cost of these, after a change of a closed
/// mesh. Skips dead ones.
std::string checkClosedManifoldAround(const SurfaceMesh& mesh, std::span<const int> triangles);

/// A vertex on the border of each piece that has some of the triangles `absent` (those of the mesh,
/// ascending), -1 for others; pieces behind the last open one are left out.
std::vector<int> verticesOnBorder(const SurfaceMesh& mesh, const std::vector<int>& pieceOfVertex,
                                  std::span<const int> absent);

/// A connected piece of the mesh. Absent walls belong to it, except for the current volume: then
/// that of the cones from a vertex on its border (verticesOnBorder) to present triangles.
struct Piece {
    int triangles = 0;
    int vertices = 0;
    double volume = 0;      ///< signed, current positions [m^3]
    double restVolume = 0;  ///< signed, rest positions [m^3]
    double restArea = 0;    ///< [m^2]
};

/// Connected components over shared vertices.
struct PieceMap {
    std::vector<int> ofVertex;  ///< piece of each vertex, -1 for unused ones
    std::vector<Piece> pieces;  ///< ordered by their lowest vertex
};
PieceMap findPieces(const SurfaceMesh& mesh);

/// Sum of signed tetrahedra over all triangles [m^3].
double meshVolume(const SurfaceMesh& mesh);
double meshRestVolume(const SurfaceMesh& mesh);
/// The present box of the living triangles [m].
Bounds meshBounds(const SurfaceMesh& mesh);

}  // namespace kerf

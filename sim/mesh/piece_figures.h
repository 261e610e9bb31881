#pragma once

#include "sim/base/math.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/mesh/union_find.h"

namespace kerf {

// A shell is a connected part of the surface. One that encloses no material but a hollow inside
// another shell bounds a cavity, and belongs to the piece of the shell around it. Which shells do
// is seen at rest: their volume is negative.

/// Whether a living triangle has the vertex.
inline bool isUsed(const SurfaceMesh& mesh, int v) {
    return mesh.outgoing(v) >= 0 && mesh.alive(mesh.outgoing(v) / 3);
}

/// The vertices of each shell as one set, named by its lowest vertex. O(n).
UnionFind shellsOf(const SurfaceMesh& mesh);

/// Joins the shell of each cavity with the one around it, so that the sets of shellsOf() become
/// pieces. Returns whether there was any. O(n), and as much again per cavity.
bool joinCavities(const SurfaceMesh& mesh, UnionFind& shells);

/// The pieces of a mesh by their shells, at the time of construction.
class PieceShells {
  public:
    /// O(n).
    explicit PieceShells(const SurfaceMesh& mesh);

    /// A triangle of each shell of the piece that `triangle` belongs to, itself the first.
    std::vector<int> shellsAround(const SurfaceMesh& mesh, int triangle) const;

  private:
    /// A shell of a piece that has several.
    struct Shell {
        int triangle;     ///< the lowest
        int shellVertex;  ///< the lowest of the shell
        int pieceVertex;  ///< the lowest of the piece
    };
    std::vector<int> shellOfVertex_;  ///< by its lowest vertex; empty where there is no cavity
    std::vector<Shell> shells_;
};

/// The present measurements of one piece.
struct PieceFigures {
    int triangles = 0;
    double skinArea = 0;           ///< [m^2]
    double cutArea = 0;            ///< of the faces of cuts [m^2]
    double volume = 0;             ///< [m^3]
    Vec3 centroid = Vec3::Zero();  ///< of its volume; without volume, of its box [m]
    Bounds bounds;                 ///< [m]
    double area() const { return skinArea + cutArea; }
};

/// Sums the piece that a living triangle belongs to. Reads back what is stale. `shells`: of the
/// present mesh.
PieceFigures figuresOfPiece(const SurfaceMesh& mesh, const PieceShells& shells, int triangle);

}  // namespace kerf

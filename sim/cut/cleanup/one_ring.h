#pragma once

#include "sim/cut/cleanup/copies.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/mesh/triangle.h"

namespace kerf::cut {

/// A triangle after a planned operation.
struct RingTriangle {
    Triangle corners;  ///< its corners then
    int slot;          ///< its slot in the mesh
    /// Area vector of the sector between two features around its old corner [m^2].
    Vec3 reference;
};

/// The triangles around one vertex before and after an operation; in `after` only `vertex` has
/// moved.
struct OneRing {
    int vertex = -1;                  ///< the vertex in the middle, which stays
    std::vector<int> merged;          ///< vertices that become `vertex`
    bool joins = false;               ///< `vertex` keeps its triangles, becomes the target's copy
    std::vector<int> before;          ///< slots of the triangles as they are
    std::vector<RingTriangle> after;  ///< the remaining triangles
    Vec3 position = Vec3::Zero();     ///< planned for `vertex` [m]
    Vec3 rest = Vec3::Zero();         ///< planned for `vertex`, at rest [m]
    Vec3 velocity = Vec3::Zero();     ///< planned for `vertex` [m/s]
};

/// The one-ring of `star`'s copy `vertex`, which moves.
OneRing ringOfMove(const SurfaceMesh& mesh, const SharedStar& star, int vertex);

/// The one-ring of `vertex`, a copy of `to`, with those of the copies of `from` that merge into it.
OneRing ringOfMerge(const SurfaceMesh& mesh, const SharedStar& from, const SharedStar& to,
                    int vertex, std::vector<int> merged);

/// The corners of a triangle of the ring after the operation [m].
Corners cornersAfter(const SurfaceMesh& mesh, const OneRing& ring, const RingTriangle& triangle);
/// The length of half-edge h [m].
double edgeLength(const SurfaceMesh& mesh, int h);
/// The half-edges of a triangle, the shortest first.
std::array<int, 3> edgesByLength(const SurfaceMesh& mesh, int triangle);

/// Whether all triangles of the rings are walls.
bool isWallOnly(const SurfaceMesh& mesh, const std::vector<OneRing>& rings);

}  // namespace kerf::cut

#pragma once

#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// The common position of v and its copies: their mean, if none is farther from it than `distance`
/// [m]; otherwise v's own position. All copies that meet get the same position to the last bit.
Vec3 commonPosition(const SurfaceMesh& mesh, int v, double distance);

/// The stroke that made a wall triangle, -1 on the skin.
inline int strokeOf(const SurfaceMesh& mesh, int t) {
    return mesh.kind(t) == SurfaceKind::wall ? mesh.wallLabel(t) / 2 : -1;
}

/// The copies of a vertex that are in use, including itself.
std::vector<int> livingCopies(const SurfaceMesh& mesh, int vertex);

/// The first copies of a triangle's corners, ascending.
Triangle pointsOf(const SurfaceMesh& mesh, int t);

/// The wall triangle between copies of the same vertices on the other side, -1 for none.
int mirrorOf(const SurfaceMesh& mesh, int t);

}  // namespace kerf::cut

namespace kerf {

/// The default edge length of walls [m]: the mean of the skin, at most a twelfth of the body's
/// diagonal, so that coarse bodies get walls finer than their skin.
inline double wallEdgeFor(double meanEdge, double diagonal) {
    constexpr double kEdgesPerDiagonal = 12;
    return std::min(meanEdge, diagonal / kEdgesPerDiagonal);
}

}  // namespace kerf

#pragma once

#include "tests/support/drawn_curves.h"

namespace kerf::test {

/// A box of size 1 about the origin that stroke 0 has cut in two in the plane z = 0.1, with walls
/// of edge length 0.3. Vertices lie up to `noise` [m] along each axis from where they were.
SurfaceMesh halvedBox(double noise);

/// The corner of triangle t that is v or a copy of it, -1 where there is none.
int copyIn(const SurfaceMesh& mesh, int t, int v);
/// The triangle on the other side of a slit, -1 where there is none.
int mirrorOf(const SurfaceMesh& mesh, int wall);
/// The living triangles of W+ of stroke 0.
std::vector<int> wallsOfPlus(const SurfaceMesh& mesh);

/// Draws the same nodes on a wall and on its mirror, in turns: a trapezium on two edges and a
/// rectangle inside, for which the Delaunay criterion has ties, and one on the third edge.
DrawnCurves drawnOnBoth(const SurfaceMesh& mesh, int wall, int mirror);

}  // namespace kerf::test

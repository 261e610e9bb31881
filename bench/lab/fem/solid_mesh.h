#pragma once

#include <array>
#include <optional>
#include <vector>

#include "sim/base/math.h"

namespace kerf {

/// A body filled with quadratic tetrahedra of ten nodes.
struct SolidMesh {
    /// The ends of the edges with a node in their middle, as corners of a tetrahedron.
    static constexpr std::array<std::array<int, 2>, 6> kEdges{
        {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

    std::vector<Vec3> nodes;  ///< at rest [m]
    /// Per tetrahedron its corners, positively oriented, then the middles of kEdges.
    std::vector<std::array<int, 10>> tetrahedra;
    std::vector<Triangle> skin;  ///< outward, four for each outer face of a tetrahedron
    /// Pairs of nodes at one place on either side of a slit: that of lower x, that of higher x.
    std::vector<std::array<int, 2>> lips;
};

/// Planes of a grid along an axis [m], ascending.
using GridLines = std::vector<double>;

/// Planes from `low` to `high`, `cells` of the same distance before `middle` and behind it as many
/// of nearly the same distance. `middle` lies strictly between.
GridLines gridLinesThrough(double low, double middle, double high, int cells);
/// Planes from `low` to `high`, so many cells of one size.
GridLines evenGridLines(double low, double high, int cells);

/// A cut by a blade without thickness: on a grid plane across x, all of it where y > `bottom` and
/// |z| < `halfWidth`. Both should be planes of the grid.
struct Slit {
    double x = 0;
    double bottom = 0;
    double halfWidth = 0;
};

/// A box of cells of six tetrahedra each (Kuhn's) between these planes along x, y and z. Along the
/// slit the nodes are there twice, so that it can open; no volume is taken.
SolidMesh solidBox(const std::array<GridLines, 3>& lines, const std::optional<Slit>& slit = {});

/// A ball around the origin, or the half of it where x >= 0. The faces of an octahedron are divided
/// into `rows` squared triangles each, whose corners are moved onto the sphere: its skin is flat
/// between them. Layers of one thickness fill it.
SolidMesh solidBall(double radius, int rows, int layers, bool half);

}  // namespace kerf

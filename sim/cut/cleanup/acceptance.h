#pragma once

#include "sim/cut/cleanup/one_ring.h"
#include "sim/cut/cleanup/workspace.h"

namespace kerf::cut {

/// The score of a triangle, 1 where it is good: the least of 1, (height over longest edge) /
/// kGoodQuality and (shortest edge) / goodEdge. `goodEdge`: Workspace::goodEdgeLength [m].
double triangleScore(const Corners& corners, double goodEdge);
/// The score of a triangle of the mesh, in its slot.
double triangleScore(const SurfaceMesh& mesh, int triangle, double goodEdge);

/// The worst score of some triangles, and how many of them are not good.
struct Scores {
    double worst = 1;  ///< the least score
    int bad = 0;       ///< the number of scores below 1
    /// Adds the score of one more triangle.
    void add(double score);
};

/// The scores of all triangles that an operation changes, as they are.
Scores scoresBefore(const Workspace& workspace, const std::vector<OneRing>& rings);
/// The scores of all triangles that an operation changes, as they would be.
Scores scoresAfter(const Workspace& workspace, const std::vector<OneRing>& rings);
/// Whether an operation makes triangles better: fewer bad ones and none worse, or a clearly better
/// worst one, or all good.
bool improves(const Scores& before, const Scores& after);

/// Whether no triangle turns over: each faces as its sector did, and nearly as before unless it was
/// a sliver.
bool keepsOrientation(const Workspace& workspace, const std::vector<OneRing>& rings);

}  // namespace kerf::cut

#pragma once

#include <vector>

#include "sim/cut/cleanup/local_patch.h"
#include "sim/cut/cleanup/workspace.h"

namespace kerf::cut {

/// min(1, height over longest edge / kGoodQuality, shortest edge / goodEdge): 1 is good.
/// `goodEdge`: Workspace::goodEdgeLength [m].
double triangleScore(const Corners& corners, double goodEdge);
double triangleScore(const SurfaceMesh& mesh, int triangle, double goodEdge);

/// The worst score of some triangles, and how many of them are not good.
struct Scores {
    double worst = 1;
    int bad = 0;
    void add(double score);
};

Scores scoresBefore(const Workspace& workspace, const std::vector<Patch>& patches);
Scores scoresAfter(const Workspace& workspace, const std::vector<Patch>& patches);
/// Fewer bad triangles and none worse, or a clearly better worst one, or all good.
bool improves(const Scores& before, const Scores& after);

/// No triangle turns over: each looks where its sector looked, and nearly where it looked itself
/// unless it was a sliver.
bool keepsOrientation(const Workspace& workspace, const std::vector<Patch>& patches);

}  // namespace kerf::cut

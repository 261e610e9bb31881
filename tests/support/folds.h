#pragma once

#include "sim/mesh/surface_mesh.h"

namespace kerf::test {

/// An edge that is bent by more than 90 degrees from rest.
struct Fold {
    std::array<std::uint32_t, 4> corners;  ///< of the edge, then those opposite
    double turn;                           ///< from rest [rad]
    double restAngle;                      ///< [rad]
};

/// All folds but edges of slivers and those with an end among `pinned` (ascending).
std::vector<Fold> foldsOf(const SurfaceMesh& mesh, const std::vector<std::uint32_t>& pinned = {});

/// How many these are.
int foldedEdges(const SurfaceMesh& mesh, const std::vector<std::uint32_t>& pinned = {});

}  // namespace kerf::test

#pragma once

#include <array>
#include <vector>

#include "sim/base/math.h"

namespace kerf::test {

/// Small-strain, linear-elastic, isotropic finite elements: constant-strain tetrahedra. A reference
/// for what Kerf's bodies do, for some thousand nodes.
struct ElasticSolid {
    std::vector<Vec3> nodes;                     ///< [m]
    std::vector<std::array<int, 4>> tetrahedra;  ///< positively oriented
    double youngsModulus = 1e5;                  ///< [Pa]
    double poissonRatio = 0.3;                   ///< below 0.5
    std::vector<Vec3> loads;                     ///< force per node [N]
    std::vector<std::array<bool, 3>> supported;  ///< per node and axis: does not move
};

/// An axis-parallel box around the origin as a lattice of cells of six tetrahedra each (Kuhn),
/// which fit together without gaps; no loads, no supports.
ElasticSolid solidBox(const Vec3& size, const std::array<int, 3>& cells);

/// Displacement of each node at rest under the loads [m]. Throws std::runtime_error where the
/// supports let the solid move freely.
std::vector<Vec3> solveElastic(const ElasticSolid& solid);

}  // namespace kerf::test

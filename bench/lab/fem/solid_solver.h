#pragma once

#include <array>
#include <optional>
#include <vector>

#include "bench/lab/fem/neo_hookean.h"
#include "bench/lab/fem/solid_mesh.h"
#include "sim/base/math.h"

namespace kerf {

/// Where a node is held along each axis [m]; none where it is free.
using Hold = std::array<std::optional<double>, 3>;

/// A node that is held where it is.
inline Hold heldAt(const Vec3& p) {
    return {p.x(), p.y(), p.z()};
}

/// A solid that is held and loaded.
struct SolidProblem {
    SolidMesh mesh;
    NeoHookean material;
    double density = 0;             ///< [kg/m^3]
    Vec3 gravity = Vec3::Zero();    ///< [m/s^2]
    std::vector<Hold> held;         ///< per node
    std::vector<Vec3> forces = {};  ///< on each node, besides gravity [N]; empty for none
    int loadSteps = 1;  ///< in which loads and holds are applied, each by the same share
};

/// A solid at rest under its loads.
struct SolidState {
    std::vector<Vec3> positions;  ///< per node [m]
    double energy = 0;            ///< elastic [J]
    int newtonSteps = 0;
    /// What of the forces is not in balance, as a share of them.
    double residual = 0;
};

/// Finds the rest of a solid by Newton's method on its energy with a line search, in doubles, with
/// four points of integration for each tetrahedron. Throws std::runtime_error where it can move
/// freely, or does not come to rest.
SolidState relaxSolid(const SolidProblem& problem);

/// Volume within the skin [m^3], with nodes at these positions.
double solidVolume(const SolidMesh& mesh, const std::vector<Vec3>& positions);

}  // namespace kerf

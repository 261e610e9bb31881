#pragma once

#include "sim/base/params.h"
#include "sim/contact/edge_push.h"
#include "sim/cut/blade.h"
#include "sim/cut/cut_types.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// The resistance of the material: the spring between the commanded edge and what it presses on. A
/// metre of edge that lags by `give` presses with the toughness, just enough to open the new
/// surface ahead; `give` is an edge length of walls, about the resolution of the mesh. See
/// docs/physics.md.
struct EdgeSpring {
    double toughness = 0;  ///< [J/m^2], > 0
    double bluntness = 0;  ///< see Params::bladeBluntness
    double give = 0;       ///< [m]
    double gate = 0;       ///< distance of one advance [m], see CutSettings::gate

    /// Stiffness of a metre of edge [N/m^2].
    double stiffness() const { return toughness / give; }
    /// The lag of the cut behind the commanded edge [m]. In an advance by the gate the spring
    /// releases the energy of the new surface. `begun`: after crack initiation.
    double lag(bool begun) const { return give * (begun ? 1 : 1 + bluntness) - 0.5 * gate; }
    /// The largest lag that presses [m].
    double mostLag(bool begun) const { return lag(begun) + gate; }
};

/// The load on an edge at its position.
struct FeltEdge {
    PressingEdge pressing;  ///< without commanded advance
    double energy = 0;      ///< in its spring [J]
};

/// The edge of a blade in the material, and its surroundings.
struct EdgeSurroundings {
    const Blade& edge;  ///< its command
    const Vec3& back;   ///< from the edge to the blade's back, unit, square to the edge
    const std::vector<RungNode>& rung;  ///< present position of the last cut
    const SurfaceMesh& mesh;
    std::span<const int> triangles;  ///< those within the largest lag of the edge
};

/// Measures the lag of an edge from the material in front of it: the front where it has cut,
/// elsewhere the surface. None if it touches nothing.
std::optional<FeltEdge> feltEdge(const EdgeSurroundings& place, const EdgeSpring& spring);

}  // namespace kerf

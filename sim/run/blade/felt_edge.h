#pragma once

#include <optional>
#include <span>
#include <vector>

#include "sim/base/params.h"
#include "sim/contact/edge_push.h"
#include "sim/cut/blade.h"
#include "sim/cut/cut_types.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// How the material holds the edge of a blade back: the spring between where the edge is led and
/// what it presses on. A metre of edge that lags by `give` presses with the toughness, just enough
/// to open the new surface ahead; `give` is an edge length of walls, about as much as the mesh can
/// show. See docs/physics.md.
struct EdgeSpring {
    double toughness = 0;  ///< [J/m^2], > 0
    double bluntness = 0;  ///< see Params::bladeBluntness
    double give = 0;       ///< [m]
    double gate = 0;       ///< way by which a cut goes on at once [m], see CutSettings::gate

    /// Stiffness of a metre of edge [N/m^2].
    double stiffness() const { return toughness / give; }
    /// How far the cut stays behind where the edge is led [m]. What the spring sets free while the
    /// cut goes on by the gate is what the new surface takes. `begun`: the edge has broken in.
    double lag(bool begun) const { return give * (begun ? 1 : 1 + bluntness) - 0.5 * gate; }
    /// The largest lag that presses [m].
    double mostLag(bool begun) const { return lag(begun) + gate; }
};

/// What an edge feels where it is.
struct FeltEdge {
    PressingEdge pressing;  ///< with no way
    double energy = 0;      ///< in its spring [J]
};

/// The edge of a blade in the material, and what lies around.
struct EdgePlace {
    const Blade& edge;  ///< where it is led
    const Vec3& back;   ///< from the edge to the blade's back, unit, square to the edge
    const std::vector<RungNode>& rung;  ///< where it last cut, as that lies now
    const SurfaceMesh& mesh;
    std::span<const int> triangles;  ///< those near the way of the edge over its largest lag
};

/// Measures how far the material in front of an edge holds it back: where it has cut, that is the
/// front, elsewhere the surface. None where it touches nothing.
std::optional<FeltEdge> feltEdge(const EdgePlace& place, const EdgeSpring& spring);

}  // namespace kerf

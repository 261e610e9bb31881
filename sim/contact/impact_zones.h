#pragma once

#include "sim/body/body_model.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// The walls of a body that are thinner than the longest edge at them, as those of plates and
/// shells of few triangles are. Contact can't tell the sides of such a wall apart.
struct ThinWalls {
    double share = 0;      ///< of the vertices, 0 to 1
    double thickness = 0;  ///< half of these walls are thinner; 0 without any [m]
    double edge = 0;       ///< half of the longest edges there are shorter; 0 without any [m]
    /// Whether they decide how the body moves: at a twentieth of the vertices at least.
    bool many() const { return share > 0.05; }
};

/// Finds the thin walls of a body at rest. O(n).
ThinWalls thinWalls(const BodyModel& model);

/// A body that a step has moved.
struct MovedBody {
    const BodyModel& model;
    const std::vector<Vec3>& before;          ///< where its vertices were [m]
    std::optional<double> floor;              ///< height [m]
    std::span<const std::uint32_t> pinned{};  ///< vertices that stay, ascending
    bool apart = true;                        ///< whether pieces are kept from each other, too
};

/// Keeps triangles from passing through each other in a step, by rigid impact zones (Provot 1997):
/// vertices of such triangles continue from where they were as one rigid body, with their momentum,
/// above the floor; so do those that they would then pass through. Triangles on both sides of a
/// slit don't count. Changes positions and velocities in `mesh`, that of the model. Returns whether
/// it did.
bool stopCrossings(const MovedBody& body, SurfaceMesh& mesh);

}  // namespace kerf

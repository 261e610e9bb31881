#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sim/body/body_model.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// Whether the material of a body is thinner than its triangles are long at a twentieth of its
/// vertices at least, as in plates and shells of few triangles. Contact can't tell the sides of
/// such a wall apart. O(n).
bool isThin(const BodyModel& model);

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

#include "sim/body/body_model.h"

namespace kerf {

BodyState stateOf(const SurfaceMesh& mesh, const std::vector<std::uint32_t>& vertices) {
    BodyState state;
    state.positions.reserve(vertices.size());
    state.velocities.reserve(vertices.size());
    for (const std::uint32_t v : vertices) {
        state.positions.push_back(mesh.position(static_cast<int>(v)).cast<float>());
        state.velocities.push_back(mesh.velocity(static_cast<int>(v)).cast<float>());
    }
    return state;
}

BodyState stateOf(const SurfaceMesh& mesh) {
    std::vector<std::uint32_t> all(mesh.vertexCount());
    std::iota(all.begin(), all.end(), 0u);
    return stateOf(mesh, all);
}

}  // namespace kerf

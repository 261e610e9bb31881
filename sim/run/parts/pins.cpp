#include "sim/run/parts/pins.h"

#include <algorithm>

namespace kerf {

Pins::RestPosition Pins::restPositionOf(const SurfaceMesh& mesh, std::uint32_t vertex) {
    const Vec3& p = mesh.restPosition(static_cast<int>(vertex));
    return {p.x(), p.y(), p.z()};
}

bool Pins::holds(int vertex) const {
    return std::ranges::binary_search(vertices_, static_cast<std::uint32_t>(vertex));
}

void Pins::collectPlaces(const SurfaceMesh& mesh) {
    positions_.clear();
    for (const std::uint32_t v : vertices_) {
        positions_.insert(restPositionOf(mesh, v));
    }
}

int Pins::change(const Region& region, bool pinned, const SurfaceMesh& mesh) {
    std::vector<std::uint32_t> after;
    int changed = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const bool before = holds(v);
        const bool chosen = mesh.outgoing(v) >= 0 && contains(region, mesh.position(v));
        changed += chosen && before != pinned;
        if (chosen ? pinned : before) {
            after.push_back(static_cast<std::uint32_t>(v));
        }
    }
    vertices_ = std::move(after);
    collectPlaces(mesh);
    return changed;
}

bool Pins::follow(const SurfaceMesh& mesh, const CutDelta& delta) {
    if (vertices_.empty()) {
        return false;
    }
    const auto isDead = [&](std::uint32_t v) { return mesh.outgoing(static_cast<int>(v)) < 0; };
    bool changed = std::erase_if(vertices_, isDead) > 0;
    for (int v = delta.firstNewVertex; v < mesh.vertexCount(); ++v) {
        const auto vertex = static_cast<std::uint32_t>(v);
        if (!isDead(vertex) && positions_.contains(restPositionOf(mesh, vertex))) {
            vertices_.push_back(vertex);
            changed = true;
        }
    }
    collectPlaces(mesh);
    return changed;
}

}  // namespace kerf

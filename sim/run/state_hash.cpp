#include "sim/run/state_hash.h"

#include <spdlog/fmt/fmt.h>

#include <bit>

namespace kerf {

void StateHash::add(std::uint32_t word) {
    for (int byte = 0; byte < 4; ++byte) {
        value_ ^= (word >> (8 * byte)) & 0xffu;
        value_ *= 0x100000001b3ull;
    }
}

void StateHash::add(const Vec3& value) {
    for (int i = 0; i < 3; ++i) {
        add(std::bit_cast<std::uint32_t>(static_cast<float>(value[i])));
    }
}

std::string StateHash::hexadecimal() const {
    return fmt::format("{:016x}", value_);
}

StateHash hashMesh(const SurfaceMesh& mesh) {
    StateHash hash;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        if (!mesh.alive(t)) {
            continue;
        }
        for (const int v : mesh.triangle(t)) {
            hash.add(static_cast<std::uint32_t>(v));
        }
        hash.add(static_cast<std::uint32_t>(mesh.kind(t)));
    }
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        hash.add(mesh.position(v));
        hash.add(mesh.velocity(v));
    }
    if (mesh.openStroke() >= 0) {
        hash.add(static_cast<std::uint32_t>(mesh.openStroke()));
    }
    return hash;
}

StateHash hashScene(const SurfaceMesh& mesh, std::span<const StaticBox> boxes) {
    StateHash hash = hashMesh(mesh);
    for (const StaticBox& box : boxes) {
        hash.add(box.center);
        hash.add(box.size);
        hash.add(box.rotate);
    }
    return hash;
}

}  // namespace kerf

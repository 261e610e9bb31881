#include "sim/run/state_hash.h"

#include <spdlog/fmt/fmt.h>

#include <bit>

namespace kerf {

namespace {

constexpr std::uint32_t kEndOfText = 0x100;  // no byte has this value

void addTopology(StateHash& hash, const SurfaceMesh& mesh) {
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        if (!mesh.alive(t)) {
            continue;
        }
        for (const int v : mesh.triangle(t)) {
            hash.add(static_cast<std::uint32_t>(v));
        }
        hash.add(static_cast<std::uint32_t>(mesh.kind(t)));
    }
}

/// Walls that are absent belong to the topology.
void addOpenStroke(StateHash& hash, const SurfaceMesh& mesh) {
    if (mesh.openStroke() >= 0) {
        hash.add(static_cast<std::uint32_t>(mesh.openStroke()));
    }
}

void addBoxes(StateHash& hash, std::span<const StaticBox> boxes) {
    for (const StaticBox& box : boxes) {
        hash.add(box.center);
        hash.add(box.size);
        hash.add(box.rotate);
    }
}

void addExactly(StateHash& hash, const Vec3& vector) {
    for (int i = 0; i < 3; ++i) {
        hash.addExactly(vector[i]);
    }
}

void addValue(StateHash& hash, const ParamValue& value) {
    hash.add(static_cast<std::uint32_t>(value.index()));
    if (const auto* number = std::get_if<double>(&value)) {
        hash.addExactly(*number);
    } else if (const auto* choice = std::get_if<std::string>(&value)) {
        hash.add(std::string_view(*choice));
    } else if (const auto* vector = std::get_if<Vec3>(&value)) {
        addExactly(hash, *vector);
    }
}

void addParameters(StateHash& hash, Params params) {
    const Params defaults;
    if (params.tearing == 0) {
        static_cast<TearParams&>(params) = {};  // materials set strengths, which wait for it
    }
    for (const ParamInfo& info : paramTable()) {
        const bool counts =
            !info.isNewer || getParam(params, info.name) != getParam(defaults, info.name);
        if (info.changesStates && counts) {
            hash.add(info.name);
            addValue(hash, getParam(params, info.name));
        }
    }
    for (const std::string& name : ownNames(params)) {
        hash.add(std::string_view(name));
        addValue(hash, getParam(params, name));
    }
}

void addBlade(StateHash& hash, const std::optional<Blade>& blade) {
    if (blade) {
        addExactly(hash, blade->a);
        addExactly(hash, blade->b);
    }
}

/// The hash of what `add` adds.
std::string hashOf(const auto& add) {
    StateHash hash;
    add(hash);
    return hash.hexadecimal();
}

std::string hashVectors(const SurfaceMesh& mesh, Vec3 (*of)(const SurfaceMesh& mesh, int v)) {
    return hashOf([&](StateHash& hash) {
        for (int v = 0; v < mesh.vertexCount(); ++v) {
            hash.add(of(mesh, v));
        }
    });
}

}  // namespace

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

void StateHash::addExactly(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    add(static_cast<std::uint32_t>(bits));
    add(static_cast<std::uint32_t>(bits >> 32));
}

void StateHash::add(std::string_view text) {
    for (const char c : text) {
        add(static_cast<std::uint32_t>(static_cast<unsigned char>(c)));
    }
    add(kEndOfText);
}

std::string StateHash::hexadecimal() const {
    return fmt::format("{:016x}", value_);
}

StateHash hashMesh(const SurfaceMesh& mesh) {
    StateHash hash;
    addTopology(hash, mesh);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        hash.add(mesh.position(v));
        hash.add(mesh.velocity(v));
    }
    addOpenStroke(hash, mesh);
    return hash;
}

StateHash hashScene(const SurfaceMesh& mesh, std::span<const StaticBox> boxes) {
    StateHash hash = hashMesh(mesh);
    addBoxes(hash, boxes);
    return hash;
}

StateHashes hashParts(const SurfaceMesh& mesh, std::span<const StaticBox> boxes,
                      const Params& params, const std::optional<Blade>& blade) {
    StateHashes hashes{hashScene(mesh, boxes).hexadecimal(), {}};
    const auto part = [&](StatePart which) -> std::string& {
        return hashes.parts[static_cast<std::size_t>(which)];
    };
    part(StatePart::topology) = hashOf([&](StateHash& hash) {
        addTopology(hash, mesh);
        addOpenStroke(hash, mesh);
    });
    part(StatePart::positions) =
        hashVectors(mesh, [](const SurfaceMesh& m, int v) -> Vec3 { return m.position(v); });
    part(StatePart::velocities) =
        hashVectors(mesh, [](const SurfaceMesh& m, int v) -> Vec3 { return m.velocity(v); });
    part(StatePart::boxes) = hashOf([&](StateHash& hash) { addBoxes(hash, boxes); });
    part(StatePart::parameters) = hashOf([&](StateHash& hash) { addParameters(hash, params); });
    part(StatePart::blade) = hashOf([&](StateHash& hash) { addBlade(hash, blade); });
    return hashes;
}

}  // namespace kerf

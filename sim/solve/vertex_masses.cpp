#include "sim/solve/vertex_masses.h"

#include <cassert>

#include "shaders/shared/bindings.h"
#include "sim/solve/float_vectors.h"

namespace kerf {

using shared::uint;

VertexMasses::VertexMasses(SolverBody& body)
    : body_(body), kernel_(gpu::Program::compute("sim/masses.comp")) {}

void VertexMasses::refresh() {
    if (stale_) {
        compute();
    }
}

void VertexMasses::compute() {
    stale_ = false;
    body_.bind();
    body_.model.areaBuffer.bindStorage(shared::kAreasBinding);
    body_.run(kernel_, body_.uniforms.vertex_count);
    holdPinned();
}

void VertexMasses::holdPinned() {
    std::vector<uint> masses;
    for (const uint v : pinned_) {
        masses.push_back(4 * v + 3);
    }
    const auto keep = Scatter::Gaps::keep;
    const std::size_t count = body_.model.areas.size();
    body_.scatter.write<float>(body_.state.positions, 4 * count, masses, keep,
                               [](uint) { return 0.0f; });
    body_.scatter.write<shared::vec4>(body_.state.velocities, count, pinned_, keep,
                                      [](uint) { return shared::vec4{}; });
}

void VertexMasses::setPinned(std::vector<uint> vertices) {
    pinned_ = std::move(vertices);
    stale_ = true;
}

void VertexMasses::anchor(int vertex, const Vec3f& velocity) {
    refresh();
    if (isPinned(vertex)) {
        return;
    }
    carries_ = true;
    setInverse(vertex, 0.0f);
    const shared::vec4 value = packed(velocity, 0.0f);
    body_.state.velocities.write(vertex, std::span<const shared::vec4>(&value, 1));
}

void VertexMasses::release(int vertex) {
    if (isPinned(vertex)) {
        return;
    }
    // As the kernel has it.
    const int p = body_.model.pieceOf[vertex];
    float mass = 0;
    if (p >= 0) {
        const shared::PieceRecord& piece = body_.pieces.pieces()[p];
        mass = piece.mass_per_area * std::max(body_.model.areas[vertex], piece.least_area);
    }
    setInverse(vertex, mass > 0.0f ? 1.0f / mass : 0.0f);
}

void VertexMasses::carry(std::span<const uint> vertices, std::span<const Vec3f> velocities) {
    assert(velocities.size() == vertices.size());
    carries_ = true;
    refresh();
    body_.scatter.write<shared::vec4>(body_.state.velocities, body_.model.areas.size(), vertices,
                                      Scatter::Gaps::keep, [&](uint v) {
                                          const auto at = std::ranges::lower_bound(vertices, v);
                                          return packed(velocities[at - vertices.begin()], 0.0f);
                                      });
}

void VertexMasses::carryFrom(std::span<const uint> vertices, std::span<const Vec3f> places,
                             std::span<const Vec3f> velocities) {
    carry(vertices, velocities);
    body_.scatter.write<shared::vec4>(body_.state.positions, body_.model.areas.size(), vertices,
                                      Scatter::Gaps::keep, [&](uint v) {
                                          const auto at = std::ranges::lower_bound(vertices, v);
                                          return packed(places[at - vertices.begin()], 0.0f);
                                      });
}

void VertexMasses::setInverse(int vertex, float value) {
    const std::size_t w = 4 * static_cast<std::size_t>(vertex) + 3;
    body_.state.positions.write(w, std::span<const float>(&value, 1));
}

}  // namespace kerf

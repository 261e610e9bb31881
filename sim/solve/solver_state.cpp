#include "sim/solve/solver_state.h"

#include <algorithm>
#include <cassert>

#include "sim/solve/float_vectors.h"

namespace kerf {

void SolverState::makeRoom(const BodyModel& model) {
    const std::size_t vertexBytes = model.restPositions.size() * sizeof(shared::vec4);
    displacement.resize(vertexBytes);
    previous.resize(vertexBytes);
    gradients.resize(vertexBytes);
    std::size_t pulls = 1;
    forEachType(model, [&](auto row, const auto& constraints) {
        pulls = std::max(pulls, decltype(row)::Gathers::kPulls * constraints.size());
    });
    corrections.resize(pulls * sizeof(shared::vec4));
}

void SolverState::assign(const BodyState& state) {
    positions.assign(packed(state.positions));
    velocities.assign(packed(state.velocities));
}

void SolverState::update(std::span<const std::uint32_t> written, const BodyState& state,
                         std::size_t count, Scatter& scatter) {
    assert(state.positions.size() == written.size() && state.velocities.size() == written.size());
    const auto place = [&](std::uint32_t v) {
        return std::ranges::lower_bound(written, v) - written.begin();
    };
    const auto keep = Scatter::Gaps::keep;
    for (gpu::Buffer* buffer : {&positions, &saved}) {
        scatter.write<shared::vec4>(*buffer, count, written, keep, [&](std::uint32_t v) {
            return packed(state.positions[place(v)], 0.0f);
        });
    }
    scatter.write<shared::vec4>(velocities, count, written, keep, [&](std::uint32_t v) {
        return packed(state.velocities[place(v)], 0.0f);
    });
}

SolverState::Places SolverState::askFor(gpu::ReadBack& back, std::size_t count) const {
    const std::size_t bytes = count * sizeof(shared::vec4);
    return {back.ask(positions, bytes), back.ask(velocities, bytes), count};
}

BodyState SolverState::take(const gpu::ReadBack& back, const Places& places) {
    return {unpacked(back.read<shared::vec4>(places.positions, places.count)),
            unpacked(back.read<shared::vec4>(places.velocities, places.count))};
}

BodyState SolverState::read(std::size_t count) const {
    const Places places = askFor(back_, count);
    back_.send();
    return take(back_, places);
}

}  // namespace kerf

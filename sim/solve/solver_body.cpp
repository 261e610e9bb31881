#include "sim/solve/solver_body.h"

#include <cassert>

#include "gpu/fetched_buffer.h"
#include "shaders/shared/bindings.h"
#include "sim/body/solver_uniforms.h"
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

SolverState::Offsets SolverState::askFor(gpu::ReadBack& back, std::size_t count) const {
    const std::size_t bytes = count * sizeof(shared::vec4);
    return {back.ask(positions, bytes), back.ask(velocities, bytes), count};
}

BodyState SolverState::take(const gpu::ReadBack& back, const Offsets& at) {
    return {unpacked(back.read<shared::vec4>(at.positions, at.count)),
            unpacked(back.read<shared::vec4>(at.velocities, at.count))};
}

BodyState SolverState::read(std::size_t count) const {
    const Offsets at = askFor(back_, count);
    back_.send();
    return take(back_, at);
}

using gpu::TexelFormat;
using shared::uint;

namespace {

// Of the edge length of walls: see BodyMeasure::largestStretch.
constexpr double kLeastMeasured = 0.25;

/// The speed [m/s] that no vertex of such a body reaches but by a blow-up: 1000 diagonals a second,
/// and what free fall adds in 100 s. `diagonal` [m], `gravity` [m/s^2].
double runawaySpeed(double diagonal, double gravity) {
    constexpr double kDiagonalsPerSecond = 1000;
    constexpr double kFall = 100;  // [s]
    return kDiagonalsPerSecond * diagonal + kFall * gravity;
}

/// Each vertex that a pull moves is named once, or two threads would write it.
[[maybe_unused]] bool nameVerticesOnce(const std::vector<shared::PullRecord>& records) {
    std::vector<uint> named;
    for (const shared::PullRecord& record : records) {
        named.push_back(record.vertex);
        if (record.leads >= shared::kFirstBond) {
            named.push_back(record.leads - shared::kFirstBond);
        }
    }
    std::ranges::sort(named);
    return std::ranges::adjacent_find(named) == named.end();
}

}  // namespace

SolverBody::SolverBody() : way(gpu::kernelWay()) {
    setPulls({});
}

void SolverBody::setParameters(const shared::SolverUniforms& parameters) {
    const shared::SolverUniforms counts = uniforms;
    uniforms = parameters;
    uniforms.vertex_count = counts.vertex_count;
    std::ranges::copy(counts.count, uniforms.count);
    uniforms.triangle_count = counts.triangle_count;
    uniforms.piece_count = counts.piece_count;
    uniforms.pull_count = counts.pull_count;
    uniforms.active_parts |= counts.active_parts & shared::kUnfoldFirmlyPart;
    uploadUniforms();
}

void SolverBody::unfoldFirmly(bool firmly) {
    if (firmly != active(shared::kUnfoldFirmlyPart)) {
        uniforms.active_parts ^= shared::kUnfoldFirmlyPart;
        uploadUniforms();
    }
}

void SolverBody::setCountsOf(const BodyModel& of) {
    setCounts(uniforms, of);
    uploadUniforms();
}

void SolverBody::setPulls(const std::vector<shared::PullRecord>& records) {
    if (records.empty() && uniforms.pull_count == 0 && pulls.size() > 0) {
        return;
    }
    assert(nameVerticesOnce(records));
    pulls.assign(records);
    uniforms.pull_count = size32(records.size());
    uploadUniforms();
}

void SolverBody::uploadUniforms() {
    const shared::vec4& g = uniforms.gravity;
    uniforms.gravity.w = static_cast<float>(kLeastMeasured * model.wallEdge);
    uniforms.runaway_speed =
        static_cast<float>(runawaySpeed(model.diagonal, Vec3(g.x, g.y, g.z).norm()));
    uniformBuffer.assign(std::span<const shared::SolverUniforms>(&uniforms, 1));
}

void SolverBody::bind() const {
    uniformBuffer.bindStorage(shared::kUniformsBinding);
    pieces.pieceBuffer.bindStorage(shared::kPiecesBinding);
    pieces.blockBuffer.bindStorage(shared::kBlocksBinding);
    const auto bindBoth = [&](const gpu::Buffer& buffer, uint binding, TexelFormat format) {
        buffer.bindStorage(binding);
        bindFetched(buffer, binding, format);
    };
    bindBoth(state.positions, shared::kPositionsBinding, TexelFormat::float32x4);
    bindBoth(state.velocities, shared::kVelocitiesBinding, TexelFormat::float32x4);
    bindBoth(state.displacement, shared::kDisplacementBinding, TexelFormat::float32x4);
    bindBoth(model.links, shared::kLinksBinding, TexelFormat::uint32x4);
    bindBoth(state.gradients, shared::kGradientsBinding, TexelFormat::float32x4);
}

void SolverBody::bindFetched(const gpu::Buffer& buffer, uint binding, TexelFormat format) const {
    gpu::bindFetched(buffer, binding, format, way);
}

gpu::Program SolverBody::compile(const std::string& name, gpu::Defines defines) const {
    return gpu::fetchingKernel("sim/" + name + ".comp", way, std::move(defines));
}

void SolverBody::run(const gpu::Program& kernel, uint threads) {
    kernel.dispatch(threads);
    ++dispatches;
}

void SolverBody::runOverBlocks(const gpu::Program& kernel) {
    bindFetched(model.neighbours.ranges, shared::kRangesBinding, TexelFormat::uint32x2);
    bindFetched(model.neighbours.entries, shared::kEntriesBinding, TexelFormat::uint32x2);
    bindFetched(pieces.placeBuffer, shared::kPlacesBinding, TexelFormat::uint32);
    pieces.pageBuffer.bindStorage(shared::kPagesBinding);
    kernel.dispatchGroups(size32(pieces.blocks().size()));
    ++dispatches;
}

}  // namespace kerf

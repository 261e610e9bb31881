#include "sim/solve/small_body.h"

#include <algorithm>
#include <string>

#include "gpu/context.h"
#include "shaders/shared/small_body_bindings.h"
#include "sim/body/incidence.h"

namespace kerf {

namespace {

using gpu::TexelFormat;
using shared::kSumRows;
using shared::uint;

/// Turns of all loops of a thread in a dispatch, with some to spare.
constexpr std::size_t kMostTurns = 64000;

/// Larger bodies take more threads than run side by side, so that each has fewer turns.
constexpr uint kSideBySide = 8;
constexpr uint kLargeGroup = 128;
constexpr std::size_t kLargeBodyVertices = 16384;

uint roundedUp(std::size_t count, uint size) {
    return static_cast<uint>((count + size - 1) / size);
}

std::size_t endsOfBends(const BodyModel& model, std::size_t v) {
    const IncidenceRange& range = model.bendIncidence.ranges[v];
    const auto first = model.bendIncidence.entries.begin();
    return std::count_if(first + range.first, first + range.end,
                         [](uint entry) { return entry % 4 < 2; });
}

/// The most turns that a vertex of a list needs in each of the loops over what touches it.
struct TurnsOfVertices {
    std::size_t edges = 0, ends = 0, apexes = 0, ispcs = 0, corners = 0;

    void add(const BodyModel& model, std::size_t v) {
        const std::size_t vertexEnds = endsOfBends(model, v);
        edges = std::max<std::size_t>(edges, valence(model.edgeIncidence, v));
        ends = std::max(ends, vertexEnds);
        apexes = std::max(apexes, valence(model.bendIncidence, v) - vertexEnds);
        ispcs = std::max<std::size_t>(ispcs, valence(model.ispcIncidence, v));
        corners = std::max<std::size_t>(corners, valence(model.neighbours, v));
    }
};

/// Of a loop: the one that finds that there is no more to do counts too.
std::size_t loop(std::size_t times, std::size_t turnsInside = 0) {
    return times * (1 + turnsInside) + 1;
}

/// Of a loop over the pairs of a list.
std::size_t pairs(std::size_t entries) {
    return (entries + 1) / 2;
}

/// How a group goes through a body: so many of its threads run side by side, and turn as often as
/// the one that needs most. They have a stretch of the vertices each (see small_body_state.glsl).
struct GroupShape {
    uint threads;
    uint sideBySide;
};

std::size_t turnsAt(const TurnsOfVertices& side) {
    return loop(side.edges) + loop(pairs(side.ends)) + loop(pairs(side.apexes) + 1) +
           loop(pairs(side.ispcs));
}

/// Of the loops over what touches a vertex, in the stretch that needs most; `all` gets the most
/// turns of all vertices.
std::size_t turnsOfLists(const BodyModel& model, const GroupShape& group, TurnsOfVertices& all) {
    const std::size_t vertices = model.restPositions.size();
    const std::size_t stretch =
        std::max<std::size_t>(roundedUp(vertices, group.threads) * group.sideBySide, 1);
    std::size_t most = 0;
    for (std::size_t begin = 0; begin < vertices; begin += stretch) {
        const std::size_t end = std::min(begin + stretch, vertices);
        std::size_t turns = 0;
        for (std::size_t first = begin; first < end; first += group.sideBySide) {
            TurnsOfVertices side;
            for (std::size_t v = first; v < std::min<std::size_t>(first + group.sideBySide, end);
                 ++v) {
                side.add(model, v);
                all.add(model, v);
            }
            turns += turnsAt(side);
        }
        most = std::max(most, turns);
    }
    return most;
}

/// Turns of loops in one sweep, at most.
std::size_t turnsOfSweep(const BodyModel& model, const GroupShape& group, TurnsOfVertices& all) {
    constexpr std::size_t kLoopsOverVertices = 4;  // with the prediction
    return loop(roundedUp(model.bends.size(), group.threads)) +
           loop(roundedUp(model.ispcs.size(), group.threads)) +
           kLoopsOverVertices * loop(roundedUp(model.restPositions.size(), group.threads)) +
           turnsOfLists(model, group, all);
}

/// Turns of loops in one substep, at most.
std::size_t turnsOfSubstep(const BodyModel& model, std::size_t blocks, uint group) {
    constexpr std::size_t kMoreLoopsOverVertices = 2;  // settling twice where hands pull, and pulls
    TurnsOfVertices all;
    std::size_t turns = turnsOfSweep(model, {group, group}, all);
    turns += kMoreLoopsOverVertices * loop(roundedUp(model.restPositions.size(), group));
    turns += loop(blocks, loop(roundedUp(shared::kPageSize, group), loop(pairs(all.corners))));
    turns += loop(roundedUp(blocks * kSumRows, group), loop(shared::kPageSize / kSumRows));
    turns += 2 * roundedUp(model.pieces.size(), group) + 1 + loop(blocks, loop(kSumRows));
    return turns;
}

}  // namespace

SmallBodySolver::Memory SmallBodySolver::suitableMemory() {
    return gpu::queryDevice().software ? Memory::texels : Memory::shared;
}

void SmallBodySolver::setBody(const BodyModel& model, std::span<const shared::BlockRecord> blocks,
                              bool asksForSweeps) {
    blocks_ = static_cast<uint>(blocks.size());
    large_ = model.restPositions.size() > shared::kSmallBodyVertices;
    substepsAtOnce_ = 0;
    sweepsAtOnce_ = 0;
    if (!large_ || asksForSweeps) {
        setSweeps(model);
    }
    const bool onePageEach = std::ranges::all_of(
        blocks, [](const shared::BlockRecord& block) { return block.page_count == 1; });
    if (!large_ && onePageEach &&
        std::max(blocks.size(), model.pieces.size()) <= shared::kSmallBodyBlocks) {
        const std::size_t turns = 1 + turnsOfSubstep(model, blocks.size(), groupSize());
        substepsAtOnce_ = static_cast<uint>(kMostTurns / turns);
    }
    parts_.resize(std::max<std::size_t>(blocks.size(), 1) * shared::kPageSize * 2 * sizeof(float));
}

void SmallBodySolver::setSweeps(const BodyModel& model) {
    const std::size_t most =
        memory_ == Memory::texels ? kLargeBodyVertices : std::size_t{shared::kSmallBodyVertices};
    if (model.restPositions.size() <= most) {
        const uint threads = groupSizeOfSweeps();
        const uint sideBySide = memory_ == Memory::texels ? kSideBySide : threads;
        TurnsOfVertices all;
        const std::size_t turns = 1 + turnsOfSweep(model, {threads, sideBySide}, all);
        sweepsAtOnce_ = static_cast<uint>(kMostTurns / turns);
    }
}

uint SmallBodySolver::groupSizeOfSweeps() const {
    return large_ ? kLargeGroup : groupSize();
}

gpu::Program SmallBodySolver::compile(uint threads, gpu::Defines defines) const {
    defines.emplace_back("SMALL_GROUP", std::to_string(threads) + "u");
    if (memory_ == Memory::texels) {
        defines.emplace_back("LOAD_IMAGES", "1");
    }
    return gpu::Program::compute("sim/small_body.comp", defines);
}

void SmallBodySolver::run(const SmallBodyBuffers& buffers, const SubstepRun& run) {
    std::optional<gpu::Program>& kernel = folds_ != nullptr ? foldedKernel_ : kernel_;
    if (!kernel) {
        kernel = compile(groupSize(),
                         folds_ != nullptr ? gpu::Defines{{"UNFOLDS", "1"}} : gpu::Defines{});
    }
    bind(buffers);
    if (folds_ != nullptr) {
        folds_->bindTexels(shared::kFoldsUnit, TexelFormat::uint32);
    }
    kernel->set("substepsToBegin", run.begins);
    kernel->set("firstIsOpen", run.firstIsOpen ? 1U : 0U);
    kernel->set("leavesOpen", run.leavesOpen ? 1U : 0U);
    kernel->set("blockCount", blocks_);
    kernel->dispatch(1, groupSize());
    gpu::storageBarrier();
}

void SmallBodySolver::run(const SmallBodyBuffers& buffers, const SweepRun& run) {
    std::optional<gpu::Program>& kernel = large_ ? largeSweepKernel_ : sweepKernel_;
    if (!kernel) {
        kernel = compile(groupSizeOfSweeps(), {{"PLAIN_PBD", "1"}});
    }
    bind(buffers);
    kernel->set("firstSweep", run.first);
    kernel->set("endSweep", run.end);
    kernel->dispatch(1, groupSizeOfSweeps());
    gpu::storageBarrier();
}

void SmallBodySolver::bind(const SmallBodyBuffers& b) const {
    b.uniforms->bindStorage(shared::kUniformsBinding);
    b.impulses->bindStorage(shared::kSmallImpulsesBinding);
    b.pieces->bindStorage(shared::kSmallPiecesBinding);
    b.blocks->bindStorage(shared::kSmallBlocksBinding);
    b.pages->bindStorage(shared::kSmallPagesBinding);
    b.pulls->bindStorage(shared::kSmallPullsBinding);
    const auto bindImage = [&](const gpu::Buffer& buffer, uint unit, TexelFormat format) {
        if (memory_ == Memory::texels) {
            buffer.bindImage(unit, format);
        }
    };
    const auto bindState = [&](const gpu::Buffer& buffer, uint binding, TexelFormat format) {
        buffer.bindStorage(binding);
        bindImage(buffer, binding, format);
    };
    const auto bindRecords = [&](const gpu::Buffer& buffer, uint unit, TexelFormat format) {
        buffer.bindTexels(unit, format);
        bindImage(buffer, unit, format);
    };
    bindState(*b.positions, shared::kPositionsBinding, TexelFormat::float32x4);
    bindState(*b.velocities, shared::kVelocitiesBinding, TexelFormat::float32x4);
    bindState(*b.displacement, shared::kDisplacementBinding, TexelFormat::float32x4);
    bindState(*b.swept, shared::kSmallSweptBinding, TexelFormat::float32x4);
    bindState(*b.corrections, shared::kSmallCorrectionsBinding, TexelFormat::float32x4);
    bindState(*b.gradients, shared::kSmallGradientsBinding, TexelFormat::float32x4);
    bindState(parts_, shared::kSmallPartsBinding, TexelFormat::float32x2);
    bindRecords(*b.links, shared::kSmallLinksUnit, TexelFormat::uint32x4);
    bindRecords(*b.edgeRanges, shared::kSmallEdgeRangesUnit, TexelFormat::uint32x2);
    bindRecords(*b.spokes, shared::kSmallSpokesUnit, TexelFormat::uint32x4);
    bindRecords(*b.bends, shared::kSmallBendsUnit, TexelFormat::uint32x4);
    bindRecords(*b.bendRanges, shared::kSmallBendRangesUnit, TexelFormat::uint32x4);
    bindRecords(*b.bendEntries, shared::kSmallBendEntriesUnit, TexelFormat::uint32x2);
    bindRecords(*b.ispcs, shared::kSmallIspcsUnit, TexelFormat::uint32x4);
    bindRecords(*b.ispcRanges, shared::kSmallIspcRangesUnit, TexelFormat::uint32x2);
    bindRecords(*b.ispcShares, shared::kSmallIspcSharesUnit, TexelFormat::uint32x4);
    bindRecords(*b.neighbourRanges, shared::kSmallNeighbourRangesUnit, TexelFormat::uint32x2);
    bindRecords(*b.neighbours, shared::kSmallNeighboursUnit, TexelFormat::uint32x2);
    bindRecords(*b.places, shared::kSmallPlacesUnit, TexelFormat::uint32);
}

}  // namespace kerf

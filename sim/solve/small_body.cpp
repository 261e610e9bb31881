#include "sim/solve/small_body.h"

#include <algorithm>
#include <array>
#include <string>

#include "gpu/fetched_buffer.h"
#include "shaders/shared/contact_records.h"
#include "shaders/shared/small_body_bindings.h"
#include "sim/solve/gathered_records.h"

namespace kerf {

namespace {

using shared::kSumRows;

std::size_t roundedUp(std::size_t count, std::size_t size) {
    return (count + size - 1) / size;
}

/// Of a loop: the turn that finds that there is no more to do counts too.
std::size_t loop(std::size_t times, std::size_t turnsInside = 0) {
    return times * (1 + turnsInside) + 1;
}

/// The turns of each loop in which a vertex gathers constraints of a type, at most two; the lists
/// of those that pull are read by pairs.
using GatherTurns = std::array<std::size_t, 2>;

GatherTurns gatherTurns(const Spokes::Range& range, Spokes) {
    return {loop(range.end - range.first), 0};
}
GatherTurns gatherTurns(const Shares::Range& range, Shares) {
    return {loop(roundedUp(range.end - range.first, 2)), 0};
}
GatherTurns gatherTurns(const WingPulls::Range& range, WingPulls) {
    return {loop(roundedUp(range.apexes - range.first, 2)),
            loop(roundedUp(range.end - (range.apexes & ~1u), 2))};
}

/// Of the threads that run side by side from vertex `first` on.
template <class Gather>
std::size_t turnsSideBySide(Gather gather, const Incidence& incidence, std::size_t first,
                            std::size_t end) {
    GatherTurns most{};
    for (std::size_t v = first; v < end; ++v) {
        const auto range = rangeAt(gather, incidence, static_cast<std::uint32_t>(v));
        const GatherTurns turns = gatherTurns(range, gather);
        most = {std::max(most[0], turns[0]), std::max(most[1], turns[1])};
    }
    return most[0] + most[1];
}

/// Of the loops in which vertices gather, in the stretch that needs most.
std::size_t turnsOfLists(const BodyModel& model, const GroupShape& group) {
    const std::size_t vertices = model.restPositions.size();
    const std::size_t stretch =
        std::max<std::size_t>(roundedUp(vertices, group.threads) * group.sideBySide, 1);
    std::vector<std::size_t> turns(roundedUp(vertices, stretch) + 1, 0);
    for (std::size_t first = 0; first < vertices; first += group.sideBySide) {
        const std::size_t end = std::min<std::size_t>(first + group.sideBySide, vertices);
        forEachType(model, [&](auto row, const auto&) {
            turns[first / stretch] += turnsSideBySide(typename decltype(row)::Gathers{},
                                                      model.incidences[row.kType], first, end);
        });
    }
    return *std::ranges::max_element(turns);
}

std::size_t loopOver(std::size_t count, const GroupShape& group, std::size_t turnsInside = 0) {
    return loop(roundedUp(count, group.threads), turnsInside);
}

std::size_t mostNeighbours(const BodyModel& model) {
    std::size_t most = 0;
    for (std::size_t v = 0; v < model.restPositions.size(); ++v) {
        most = std::max<std::size_t>(most, valence(model.neighbours, v));
    }
    return most;
}

using gpu::TexelFormat;
using shared::uint;

/// Larger bodies take more threads than run side by side, so that each has fewer turns.
constexpr uint kSideBySide = 8;
constexpr uint kLargeGroup = 128;
constexpr std::size_t kLargeBodyVertices = 16384;

}  // namespace

std::size_t turnsOfSweep(const BodyModel& model, const GroupShape& group) {
    constexpr std::size_t kLoopsOverVertices = 1 + kConstraintTypes;  // with the prediction
    std::size_t turns = 1 + kLoopsOverVertices * loopOver(model.restPositions.size(), group);
    forEachType(model, [&](auto row, const auto& constraints) {
        const bool pulls = decltype(row)::Gathers::kPulls > 0;
        turns += pulls ? loopOver(constraints.size(), group) : 0;
    });
    return turns + turnsOfLists(model, group);
}

std::size_t turnsOfSubstep(const BodyModel& model, std::size_t blocks, const GroupShape& group) {
    constexpr std::size_t kMoreLoopsOverVertices = 2;  // settling twice where hands pull, and pulls
    const std::size_t corners = mostNeighbours(model);
    return turnsOfSweep(model, group) +
           kMoreLoopsOverVertices * loopOver(model.restPositions.size(), group) +
           loop(blocks, loopOver(shared::kPageSize, group, loop(roundedUp(corners, 2)))) +
           loopOver(blocks * kSumRows, group, loop(shared::kPageSize / kSumRows)) +
           loopOver(model.pieces.size(), group, 1) + loop(blocks, loop(kSumRows));
}

std::size_t turnsOfContact(const BodyModel& model, const GroupShape& group) {
    const std::size_t vertices = model.restPositions.size();
    const std::size_t looks = loop(shared::kCandidatesPerPoint) + loop(shared::kEdgePairsPerPoint);
    return loopOver(vertices, group, looks) + 3 * loopOver(vertices, group);
}

std::size_t turnsOfUnfolding(const BodyModel& model, const GroupShape& group) {
    constexpr std::size_t kRotation = 12 + 1 + 3 + 1;  // loops of best_rotation.glsl
    const std::size_t vertices = model.restPositions.size();
    const std::size_t ring = loop(mostNeighbours(model) + 1);
    return loopOver(vertices, group) + loopOver(model.bends.size(), group, loop(1)) +
           2 * loopOver(vertices, group, ring) +
           loopOver(vertices, group, loop(1, 3 * ring + kRotation));
}

std::size_t turnsOfBoxes(const BodyModel& model, std::size_t boxes, const GroupShape& group) {
    const std::size_t triangles = model.triangles.size();
    const std::size_t vertices = model.restPositions.size();
    const std::size_t touch = 2 * loop(3) + loop(8, loop(3, loop(3))) + loop(1, loop(3));
    const std::size_t keepOut = loop(3) + loop(6);
    return loopOver(triangles, group, loop(boxes, touch)) + loopOver(triangles, group) +
           loopOver(vertices, group) + loopOver(vertices, group, loop(boxes, keepOut));
}

void SmallBodySolver::setBody(const BodyModel& model, std::span<const shared::BlockRecord> blocks,
                              bool asksForSweeps) {
    blocks_ = static_cast<uint>(blocks.size());
    large_ = model.restPositions.size() > shared::kSmallBodyVertices;
    substepTurns_ = 0;
    touchTurns_ = 0;
    foldedTurns_ = 0;
    sweepTurns_ = 0;
    if (!large_ || asksForSweeps) {
        setSweeps(model);
    }
    const bool onePageEach = std::ranges::all_of(
        blocks, [](const shared::BlockRecord& block) { return block.page_count == 1; });
    if (!large_ && onePageEach &&
        std::max(blocks.size(), model.pieces.size()) <= shared::kSmallBodyBlocks) {
        const GroupShape group{groupSize(), groupSize()};
        substepTurns_ = kerf::turnsOfSubstep(model, blocks.size(), group);
        const GroupShape touching{touchingGroupSize(), touchingGroupSize()};
        touchTurns_ =
            kerf::turnsOfSubstep(model, blocks.size(), touching) + turnsOfContact(model, touching);
        foldedTurns_ = touchTurns_ + turnsOfUnfolding(model, touching);
        turnsBesideBoxes_ = kerf::turnsOfBoxes(model, 0, touching);
        turnsOfBox_ = kerf::turnsOfBoxes(model, 1, touching) - turnsBesideBoxes_;
    }
    parts_.resize(std::max<std::size_t>(blocks.size(), 1) * shared::kPageSize * 2 * sizeof(float));
}

void SmallBodySolver::setSweeps(const BodyModel& model) {
    const std::size_t most = way_ == gpu::KernelWay::images
                                 ? kLargeBodyVertices
                                 : std::size_t{shared::kSmallBodyVertices};
    if (model.restPositions.size() <= most) {
        const uint threads = groupSizeOfSweeps();
        const uint sideBySide = way_ == gpu::KernelWay::images ? kSideBySide : threads;
        sweepTurns_ = kerf::turnsOfSweep(model, {threads, sideBySide});
    }
}

uint SmallBodySolver::groupSizeOfSweeps() const {
    return large_ ? kLargeGroup : groupSize();
}

gpu::Program SmallBodySolver::compile(uint threads, gpu::Defines defines) const {
    defines.emplace_back("SMALL_GROUP", std::to_string(threads) + "u");
    return gpu::fetchingKernel("sim/small_body.comp", way_, defines);
}

void SmallBodySolver::run(const SolverBody& body, const SubstepRun& run) {
    this->run(body, {run.begins, run.firstIsOpen ? 1U : 0U, run.leavesOpen ? 1U : 0U, blocks_},
              nullptr);
}

void SmallBodySolver::run(const SolverBody& body, uint substeps, const Collisions& collisions) {
    run(body, {substeps, 0, 0, blocks_}, &collisions);
}

void SmallBodySolver::run(const SolverBody& body, const gpu::DispatchNumbers& numbers,
                          const Collisions* collisions) {
    const bool folded = folds_ != nullptr;
    const bool boxes = collisions != nullptr && collisions->boxes().mayTouch();
    const std::size_t touched = boxes ? 2 : (collisions != nullptr ? 1 : 0);
    std::optional<gpu::Program>& kernel = kernels_[touched][folded ? 1 : 0];
    if (!kernel) {
        constexpr std::array<const char*, 2> kTouched{"COLLIDES", "MEETS_BOXES"};
        gpu::Defines defines = folded ? gpu::Defines{{"UNFOLDS", "1"}} : gpu::Defines{};
        for (std::size_t i = 0; i < touched; ++i) {
            defines.emplace_back(kTouched[i], "1");
        }
        kernel = compile(collisions != nullptr ? touchingGroupSize() : groupSize(), defines);
    }
    bind(body);
    if (collisions != nullptr) {
        collisions->contacts().bindAnswers(
            {shared::kSmallContactBinding, shared::kSmallRecordsBinding, shared::kSmallSumsBinding,
             shared::kSmallStateBinding},
            way_);
    }
    if (boxes) {
        collisions->boxes().bindAnswers(
            {shared::kSmallObstacleBinding, shared::kSmallTouchesBinding, shared::kSmallBoxesUnit,
             shared::kSmallPieceBoundsUnit},
            way_);
    }
    if (folded) {
        folds_->bindStorage(shared::kSmallFoldsBinding);
        gpu::bindFetched(*folds_, shared::kFoldsUnit, TexelFormat::uint32, way_);
    }
    kernel->setNumbers(numbers);
    kernel->dispatch(1);
}

void SmallBodySolver::run(const SolverBody& body, const SweepRun& run) {
    std::optional<gpu::Program>& kernel = large_ ? largeSweepKernel_ : sweepKernel_;
    if (!kernel) {
        kernel = compile(groupSizeOfSweeps(), {{"PLAIN_PBD", "1"}});
    }
    bind(body);
    kernel->setNumbers({run.first, run.end});
    kernel->dispatch(1);
}

void SmallBodySolver::bind(const SolverBody& body) const {
    body.uniformBuffer.bindStorage(shared::kUniformsBinding);
    body.pieces.impulses.bindStorage(shared::kSmallImpulsesBinding);
    body.pieces.pieceBuffer.bindStorage(shared::kSmallPiecesBinding);
    const auto bindImage = [&](const gpu::Buffer& buffer, uint unit, TexelFormat format) {
        if (way_ == gpu::KernelWay::images) {
            buffer.bindImage(unit, format);
        }
    };
    const auto bindState = [&](const gpu::Buffer& buffer, uint binding, TexelFormat format) {
        buffer.bindStorage(binding);
        bindImage(buffer, binding, format);
    };
    const auto bindRecords = [&](const gpu::Buffer& buffer, uint unit, TexelFormat format) {
        gpu::bindFetched(buffer, unit, format, way_);
    };
    bindState(body.state.positions, shared::kPositionsBinding, TexelFormat::float32x4);
    bindState(body.state.velocities, shared::kVelocitiesBinding, TexelFormat::float32x4);
    bindState(body.state.displacement, shared::kDisplacementBinding, TexelFormat::float32x4);
    bindState(body.state.previous, shared::kSmallSweptBinding, TexelFormat::float32x4);
    bindState(body.state.corrections, shared::kSmallCorrectionsBinding, TexelFormat::float32x4);
    bindState(body.state.gradients, shared::kSmallGradientsBinding, TexelFormat::float32x4);
    bindState(parts_, shared::kSmallPartsBinding, TexelFormat::float32x2);
    bindRecords(body.model.links, shared::kSmallLinksUnit, TexelFormat::uint32x4);
    bindAllConstraints(body.model.constraints, bindRecords);
    bindRecords(body.model.neighbours.ranges, shared::kSmallNeighbourRangesUnit,
                TexelFormat::uint32x2);
    bindRecords(body.model.neighbours.entries, shared::kSmallNeighboursUnit, TexelFormat::uint32x2);
    bindRecords(body.pieces.placeBuffer, shared::kSmallPlacesUnit, TexelFormat::uint32);
    bindRecords(body.pieces.blockBuffer, shared::kSmallBlocksUnit, TexelFormat::uint32);
    bindRecords(body.pieces.pageBuffer, shared::kSmallPagesUnit, TexelFormat::uint32);
    bindRecords(body.pulls, shared::kSmallPullsUnit, TexelFormat::uint32x4);
    bindRecords(body.model.restPositions, shared::kSmallRestUnit, TexelFormat::float32x4);
}

}  // namespace kerf

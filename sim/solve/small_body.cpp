#include "sim/solve/small_body.h"

#include <algorithm>
#include <string>

#include "shaders/shared/small_body_bindings.h"

namespace kerf {

namespace {

using gpu::TexelFormat;
using shared::uint;

/// Larger bodies take more threads than run side by side, so that each has fewer turns.
constexpr uint kSideBySide = 8;
constexpr uint kLargeGroup = 128;
constexpr std::size_t kLargeBodyVertices = 16384;

}  // namespace

void SmallBodySolver::setBody(const BodyModel& model, std::span<const shared::BlockRecord> blocks,
                              bool asksForSweeps) {
    blocks_ = static_cast<uint>(blocks.size());
    large_ = model.restPositions.size() > shared::kSmallBodyVertices;
    substepTurns_ = 0;
    sweepTurns_ = 0;
    if (!large_ || asksForSweeps) {
        setSweeps(model);
    }
    const bool onePageEach = std::ranges::all_of(
        blocks, [](const shared::BlockRecord& block) { return block.page_count == 1; });
    if (!large_ && onePageEach &&
        std::max(blocks.size(), model.pieces.size()) <= shared::kSmallBodyBlocks) {
        substepTurns_ = kerf::turnsOfSubstep(model, blocks.size(), {groupSize(), groupSize()});
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
    if (way_ == gpu::KernelWay::images) {
        defines.emplace_back("LOAD_IMAGES", "1");
    }
    return gpu::Program::compute("sim/small_body.comp", defines);
}

void SmallBodySolver::run(const SolverBody& body, const SubstepRun& run) {
    std::optional<gpu::Program>& kernel = folds_ != nullptr ? foldedKernel_ : kernel_;
    if (!kernel) {
        kernel = compile(groupSize(),
                         folds_ != nullptr ? gpu::Defines{{"UNFOLDS", "1"}} : gpu::Defines{});
    }
    bind(body);
    if (folds_ != nullptr) {
        folds_->bindTexels(shared::kFoldsUnit, TexelFormat::uint32);
    }
    kernel->setNumbers({run.begins, run.firstIsOpen ? 1U : 0U, run.leavesOpen ? 1U : 0U, blocks_});
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
    body.pieces.blockBuffer.bindStorage(shared::kSmallBlocksBinding);
    body.pieces.pageBuffer.bindStorage(shared::kSmallPagesBinding);
    body.pulls.bindStorage(shared::kSmallPullsBinding);
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
        buffer.bindTexels(unit, format);
        bindImage(buffer, unit, format);
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
}

}  // namespace kerf

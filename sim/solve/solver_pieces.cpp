#include "sim/solve/solver_pieces.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "sim/solve/float_vectors.h"

namespace kerf {

namespace {

using shared::uint;

static_assert(sizeof(shared::PieceRecord) == 28);
static_assert(sizeof(shared::BlockRecord) == 12);
static_assert(sizeof(shared::VolumeSum) == 8);
static_assert(sizeof(shared::VolumeImpulse) == 8);
static_assert(sizeof(shared::BlockMeasure) == 96);

// One thread adds up the blocks of a piece, so there are few of them; and a thread goes through the
// pages of a block, so these may not be too many either: llvmpipe ends loops after 65,535 turns.
constexpr uint kBlocksPerPiece = 32;
constexpr uint kMaxPagesPerBlock = 64;

void appendBlocks(std::vector<shared::BlockRecord>& blocks, uint piece, uint firstPage,
                  uint pageCount) {
    const uint size =
        std::min((pageCount + kBlocksPerPiece - 1) / kBlocksPerPiece, kMaxPagesPerBlock);
    for (uint done = 0; done < pageCount; done += size) {
        blocks.push_back({piece, firstPage + done, std::min(size, pageCount - done)});
    }
}

}  // namespace

void SolverPieces::setPages(VertexPages pages) {
    pages_ = std::move(pages);
    pages_.takeChangedPlaces();
    placeBuffer.assign(pages_.places());
}

void SolverPieces::updatePages(std::span<const LabelMove> moves, const BodyModel& model) {
    pages_.update(moves, model.restPositions.size(), model.pieces.size());
}

void SolverPieces::upload(const BodyModel& model, Scatter& scatter) {
    std::vector<uint> pageTable;
    pieces_.clear();
    blocks_.clear();
    for (std::size_t p = 0; p < model.pieces.size(); ++p) {
        addRecord(model.pieces[p], p, pageTable);
    }
    scatter.write<uint>(placeBuffer, pages_.places(), pages_.takeChangedPlaces());
    pageBuffer.assign(pageTable);
    pieceBuffer.assign(pieces_);
    blockBuffer.assign(blocks_);
    makeRoomForSums();
}

void SolverPieces::addRecord(const PieceModel& piece, std::size_t number,
                             std::vector<uint>& table) {
    const std::vector<uint>& pages = pages_.pagesOf(number);
    const uint firstBlock = size32(blocks_.size());
    appendBlocks(blocks_, size32(number), size32(table.size()), size32(pages.size()));
    table.insert(table.end(), pages.begin(), pages.end());
    const uint origin =
        piece.rimVertex >= 0 ? static_cast<uint>(piece.rimVertex) : pages_.anyVertexOf(number);
    pieces_.push_back({origin, firstBlock, size32(blocks_.size()) - firstBlock,
                       piece.holdsVolume ? 1u : 0u, static_cast<float>(piece.restVolume),
                       static_cast<float>(piece.massPerArea), static_cast<float>(piece.leastArea)});
}

void SolverPieces::makeRoomForSums() {
    blockSums.resize(std::max<std::size_t>(blocks_.size(), 1) * sizeof(shared::VolumeSum));
    impulses.resize(std::max<std::size_t>(pieces_.size(), 1) * sizeof(shared::VolumeImpulse));
    blockMeasures.resize((blocks_.size() + 1) * sizeof(shared::BlockMeasure));
}

void SolverPieces::setVolumeTargets(std::span<const VolumeTarget> targets) {
    assert(targets.size() == pieces_.size());
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
        pieces_[p].target_volume = static_cast<float>(targets[p].volume);
        pieces_[p].constrained = targets[p].constrained ? 1 : 0;
    }
    pieceBuffer.assign(pieces_);
}

}  // namespace kerf

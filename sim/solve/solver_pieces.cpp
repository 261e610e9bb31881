#include "sim/solve/solver_pieces.h"

#include <cassert>

#include "sim/base/containers.h"
#include "sim/solve/float_vectors.h"

namespace kerf {

namespace {

using shared::uint;

static_assert(sizeof(shared::PieceRecord) == 28);
static_assert(sizeof(shared::BlockRecord) == 12);
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

using shared::kNoVertex;
using shared::kPageSize;

void VertexPages::assign(std::span<const int> pieceOfVertex, std::size_t pieceCount) {
    *this = {};
    pieces_.resize(pieceCount);
    placeOf_.resize(pieceOfVertex.size(), 0);
    for (std::size_t v = 0; v < pieceOfVertex.size(); ++v) {
        if (const int piece = pieceOfVertex[v]; piece >= 0) {
            put(static_cast<std::uint32_t>(v), pieces_[piece]);
        }
    }
}

void VertexPages::update(std::span<const LabelMove> moves, std::size_t vertexCount,
                         std::size_t pieceCount) {
    placeOf_.resize(vertexCount, 0);
    for (const LabelMove& move : moves) {
        if (move.from >= 0) {
            take(static_cast<std::uint32_t>(move.vertex), pieces_[move.from]);
        }
    }
    for (std::size_t p = pieceCount; p < pieces_.size(); ++p) {
        freePages_.insert(freePages_.end(), pieces_[p].pages.begin(), pieces_[p].pages.end());
    }
    pieces_.resize(pieceCount);
    for (const LabelMove& move : moves) {
        if (move.to >= 0) {
            put(static_cast<std::uint32_t>(move.vertex), pieces_[move.to]);
        }
    }
    for (Piece& piece : pieces_) {
        if (piece.holes.size() > piece.vertices + kPageSize) {
            pack(piece);
        }
    }
}

void VertexPages::set(std::uint32_t place, std::uint32_t vertex) {
    places_[place] = vertex;
    changed_.push_back(place);
}

void VertexPages::put(std::uint32_t vertex, Piece& piece) {
    if (piece.holes.empty()) {
        addPage(piece);
    }
    placeOf_[vertex] = piece.holes.back();
    set(piece.holes.back(), vertex);
    piece.holes.pop_back();
    ++piece.vertices;
}

void VertexPages::take(std::uint32_t vertex, Piece& piece) {
    set(placeOf_[vertex], kNoVertex);
    piece.holes.push_back(placeOf_[vertex]);
    --piece.vertices;
}

void VertexPages::addPage(Piece& piece) {
    std::uint32_t page = 0;
    if (freePages_.empty()) {
        page = static_cast<std::uint32_t>(places_.size()) / kPageSize;
        places_.resize(places_.size() + kPageSize, kNoVertex);
    } else {
        page = freePages_.back();
        freePages_.pop_back();
    }
    piece.pages.push_back(page);
    for (std::uint32_t place = (page + 1) * kPageSize; place > page * kPageSize; --place) {
        set(place - 1, kNoVertex);
        piece.holes.push_back(place - 1);
    }
}

void VertexPages::pack(Piece& piece) {
    const Piece sparse = std::exchange(piece, {});
    std::vector<std::uint32_t> vertices;
    for (const std::uint32_t page : sparse.pages) {
        for (std::uint32_t place = page * kPageSize; place < (page + 1) * kPageSize; ++place) {
            if (places_[place] != kNoVertex) {
                vertices.push_back(places_[place]);
            }
        }
    }
    freePages_.insert(freePages_.end(), sparse.pages.rbegin(), sparse.pages.rend());
    for (const std::uint32_t vertex : vertices) {
        put(vertex, piece);
    }
}

std::uint32_t VertexPages::anyVertexOf(std::size_t piece) const {
    for (const std::uint32_t page : pieces_[piece].pages) {
        for (std::uint32_t place = page * kPageSize; place < (page + 1) * kPageSize; ++place) {
            if (places_[place] != kNoVertex) {
                return places_[place];
            }
        }
    }
    return kNoVertex;
}

std::vector<std::uint32_t> VertexPages::takeChangedPlaces() {
    sortUnique(changed_);
    return std::exchange(changed_, {});
}

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
    blockSums.resize(std::max<std::size_t>(blocks_.size(), 1) * sizeof(float));
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

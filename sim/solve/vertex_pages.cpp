#include "sim/solve/vertex_pages.h"

#include <algorithm>
#include <utility>

#include "sim/base/sort_unique.h"

namespace kerf {

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

}  // namespace kerf

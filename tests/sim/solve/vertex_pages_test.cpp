#include <gtest/gtest.h>

#include <random>

#include "sim/solve/solver_pieces.h"

namespace kerf {
namespace {

using shared::kNoVertex;
using shared::kPageSize;

/// Every vertex stands once, on a page of its piece, and no page belongs to two.
void expectHolds(const VertexPages& pages, const std::vector<int>& pieceOf, std::size_t pieces) {
    std::vector<int> seen(pieceOf.size(), 0);
    std::vector<int> owner(pages.places().size() / kPageSize, -1);
    for (std::size_t p = 0; p < pieces; ++p) {
        for (const std::uint32_t page : pages.pagesOf(p)) {
            ASSERT_EQ(std::exchange(owner[page], static_cast<int>(p)), -1);
            for (std::uint32_t i = 0; i < kPageSize; ++i) {
                const std::uint32_t v = pages.places()[page * kPageSize + i];
                if (v != kNoVertex) {
                    EXPECT_EQ(pieceOf[v], static_cast<int>(p));
                    ++seen[v];
                }
            }
        }
    }
    for (std::size_t v = 0; v < pieceOf.size(); ++v) {
        EXPECT_EQ(seen[v], pieceOf[v] >= 0 ? 1 : 0) << v;
    }
}

TEST(VertexPages, KeepVerticesOfAPieceTogetherInOrder) {
    std::vector<int> pieceOf(1000, 0);
    for (int v = 0; v < 1000; v += 3) {
        pieceOf[v] = 1;
    }
    VertexPages pages;
    pages.assign(pieceOf, 2);
    expectHolds(pages, pieceOf, 2);
    EXPECT_EQ(pages.anyVertexOf(0), 1u);
    EXPECT_EQ(pages.anyVertexOf(1), 0u);
    EXPECT_EQ(pages.places()[pages.pagesOf(1)[0] * kPageSize + 1], 3u);
}

TEST(VertexPages, FollowVerticesThatComeAndGo) {
    const unsigned seed = 4;
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::vector<int> pieceOf(2000, 0);
    std::vector<std::uint32_t> copy;
    VertexPages pages;
    pages.assign(pieceOf, 1);
    for (int round = 1; round < 20; ++round) {
        std::vector<LabelMove> moves;
        for (std::size_t v = 0; v < pieceOf.size(); ++v) {
            if (random() % 4 == 0) {
                const int to = static_cast<int>(random() % (round + 1)) - (random() % 8 == 0);
                moves.push_back({static_cast<int>(v), pieceOf[v], to});
                pieceOf[v] = to;
            }
        }
        for (int i = 0; i < 30; ++i) {
            moves.push_back({static_cast<int>(pieceOf.size()), -1, 0});
            pieceOf.push_back(0);
        }
        pages.update(moves, pieceOf.size(), round + 1);
        expectHolds(pages, pieceOf, round + 1);
        copy.resize(pages.places().size());
        for (const std::uint32_t place : pages.takeChangedPlaces()) {
            copy[place] = pages.places()[place];
        }
        EXPECT_EQ(copy, pages.places());
    }
}

TEST(VertexPages, APieceThatLostMostOfItsVerticesIsPacked) {
    std::vector<int> pieceOf(20 * kPageSize, 0);
    VertexPages pages;
    pages.assign(pieceOf, 1);
    std::vector<LabelMove> moves;
    for (std::size_t v = 0; v < pieceOf.size(); ++v) {
        if (v % 10 != 0) {
            moves.push_back({static_cast<int>(v), 0, 1});
            pieceOf[v] = 1;
        }
    }
    pages.update(moves, pieceOf.size(), 2);
    expectHolds(pages, pieceOf, 2);
    EXPECT_LE(pages.pagesOf(0).size(), 3u);
}

}  // namespace
}  // namespace kerf

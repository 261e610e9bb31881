#include <gtest/gtest.h>

#include <random>

#include "sim/cut/exact/directed_edges.h"
#include "tests/support/fuzz_seed.h"

namespace kerf::cut {
namespace {

constexpr int kEnds = 50;

// Far apart and close together, and more than there was room for at the start.
TEST(VertexNumbers, AreThoseThatWereGiven) {
    const std::uint32_t seed = test::fuzzSeed(111);
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random{seed};
    VertexNumbers numbers(4);
    std::map<int, int> wanted;
    for (int i = 0; i < 2000; ++i) {
        const int vertex = static_cast<int>(random() % (i % 2 == 0 ? 2000u : 2000000000u));
        if (wanted.emplace(vertex, i).second) {
            numbers.add(vertex, i);
        }
        EXPECT_EQ(numbers.find(vertex + 1), wanted.count(vertex + 1) > 0 ? wanted[vertex + 1] : -1);
    }
    EXPECT_EQ(numbers.size(), wanted.size());
    for (const auto& [vertex, number] : wanted) {
        EXPECT_EQ(numbers.find(vertex), number);
    }
}

TEST(DirectedEdges, KeepTheirFirstNumber) {
    const std::uint32_t seed = test::fuzzSeed(112);
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random{seed};
    DirectedEdges edges(kEnds);
    std::map<std::pair<int, int>, int> wanted;
    for (int i = 0; i < 1000; ++i) {
        const int from = static_cast<int>(random() % kEnds);
        const int to = static_cast<int>(random() % kEnds);
        EXPECT_EQ(edges.add(from, to, i), wanted.emplace(std::pair(from, to), i).second);
    }
    for (int from = 0; from < kEnds + 5; ++from) {
        for (int to = 0; to < kEnds + 5; ++to) {
            const auto found = wanted.find({from, to});
            EXPECT_EQ(edges.find(from, to), found == wanted.end() ? -1 : found->second);
            EXPECT_EQ(edges.has(from, to), found != wanted.end());
        }
    }
}

}  // namespace
}  // namespace kerf::cut

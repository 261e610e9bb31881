#include <gtest/gtest.h>

#include "sim/cut/plan/curves/curve_nodes.h"
#include "tests/support/step_bench.h"

namespace kerf::cut {
namespace {

/// A mesh triangle in the plane z = 0, and a strip triangle in the plane x = `x`.
struct Crossed {
    explicit Crossed(double x)
        : strip(0, {0, 1, 2}, {Vec3(x, -1, -1), Vec3(x, 3, -1), Vec3(x, 0, 2)}) {
        mesh.putInOrder();
    }
    SeenTriangle mesh{{7, 8, 9}, {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)}};
    StripTriangle strip;

    TrianglePair pair() const { return {mesh, strip, {}}; }
};

TEST(TrianglePair, OrderDoesNotHangOnTheCornerThatComesFirst) {
    SeenTriangle a{{7, 8, 9}, {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)}};
    SeenTriangle b{{9, 8, 7}, {Vec3(0, 4, 0), Vec3(4, 0, 0), Vec3(0, 0, 0)}};
    a.putInOrder();
    b.putInOrder();
    EXPECT_EQ(a.inOrder(), b.inOrder());
    EXPECT_EQ(a.parity, -b.parity) << "they face opposite ways";
}

TEST(TrianglePair, ThoseApartHaveNoSigns) {
    const Crossed crossed(-1);
    EXPECT_TRUE(areApart(crossed.pair()));
    EXPECT_EQ(signsOf(crossed.pair()), std::nullopt);
}

TEST(TrianglePair, AnEdgeThatPiercesTellsWhere) {
    const Crossed crossed(1);
    const TrianglePair pair = crossed.pair();
    EXPECT_FALSE(areApart(pair));
    const std::optional<PairSigns> signs = signsOf(pair);
    ASSERT_TRUE(signs);
    int entries = 0;
    int exits = 0;
    for (int i = 0; i < 3; ++i) {
        if (const std::optional<Crossing> crossing = meshEdgeCrossing(pair, *signs, i)) {
            const Vec3& from = pair.mesh.at[crossing->from];
            const Vec3 place = from + crossing->t * (pair.mesh.at[crossing->to] - from);
            EXPECT_NEAR(place.x(), 1, 1e-15);
            Vec3 mixed = Vec3::Zero();
            for (int k = 0; k < 3; ++k) {
                mixed += crossing->weights[k] * pair.strip.at[k];
            }
            EXPECT_LT((mixed - place).norm(), 1e-14);
            (crossing->isExit ? exits : entries) += 1;
        }
        if (const std::optional<Crossing> crossing = stripEdgeCrossing(pair, *signs, i)) {
            (crossing->isExit ? exits : entries) += 1;
        }
    }
    EXPECT_EQ(entries, 1);
    EXPECT_EQ(exits, 1);
}

TEST(TrianglePair, AnEdgeThatMeetsAnEdgeIsRefused) {
    const SeenTriangle mesh{{7, 8, 9}, {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)}};
    const StripTriangle strip(0, {0, 1, 2}, {Vec3(1, 0, -1), Vec3(1, 3, 0.5), Vec3(1, 0, 2)});
    const TrianglePair pair{mesh, strip, {}};
    const std::optional<PairSigns> signs = signsOf(pair);
    ASSERT_TRUE(signs);
    EXPECT_EQ(test::reasonOf([&] { meshEdgeCrossing(pair, *signs, 0); }),
              "degenerate: an edge meets an edge");
}

TEST(TrianglePair, ASharedVertexIsOnTwoEdgesOfEach) {
    const SharedVertex none;
    const SharedVertex shared{1, 7, 0, 2};
    EXPECT_FALSE(none.isOnMeshEdge(0) || none.isOnStripEdge(2));
    EXPECT_TRUE(shared.isOnMeshEdge(0) && shared.isOnMeshEdge(2));
    EXPECT_FALSE(shared.isOnMeshEdge(1));
    EXPECT_TRUE(shared.isOnStripEdge(2) && shared.isOnStripEdge(1));
    EXPECT_FALSE(shared.isOnStripEdge(0));
}

}  // namespace
}  // namespace kerf::cut

#include <gtest/gtest.h>

#include "sim/cut/blade.h"
#include "sim/cut/plan/strip/new_rung.h"
#include "sim/cut/plan/strip/strip.h"
#include "sim/cut/plan/strip/swept_strip.h"
#include "tests/support/shapes.h"
#include "tests/support/step_bench.h"

namespace kerf::cut {
namespace {

using test::bladeAt;

/// A box that has been cut half through.
class Rungs : public ::testing::Test {
  protected:
    Rungs() {
        bench.begin(bladeAt(1, 0.1));
        bench.cutTo(bladeAt(0, 0.1));
    }
    test::StepBench bench{test::box(), 0.25};
};

TEST_F(Rungs, TheOldOneStandsForTheFrontInItsOrder) {
    const StepInput in = bench.stepTo(bladeAt(-0.3, 0.1));
    PredicatePositions positions(in);
    const std::vector<StripNode> nodes = oldRung(in, positions);
    ASSERT_EQ(nodes.size(), in.rung.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        EXPECT_EQ(nodes[i].vertices.empty(), in.rung[i].vertex < 0);
        EXPECT_EQ(nodes[i].attached, in.rung[i].attached);
        EXPECT_EQ(nodes[i].position, in.rung[i].position);
        EXPECT_TRUE(i == 0 || nodes[i].s > nodes[i - 1].s);
    }
}

TEST_F(Rungs, FrontVerticesAtOnePlaceShareANodeAndArePinnedToIt) {
    StepInput in = bench.stepTo(bladeAt(-0.3, 0.1));
    in.attempt.tolerance = 100;
    PredicatePositions positions(in);
    const std::vector<StripNode> nodes = oldRung(in, positions);
    EXPECT_LT(nodes.size(), in.rung.size());
    int shared = 0;
    for (const StripNode& node : nodes) {
        for (const int v : node.vertices) {
            if (node.vertices.size() > 1) {
                EXPECT_EQ(positions.at(v), node.position);
                ++shared;
            }
        }
    }
    EXPECT_GT(shared, 1);
}

TEST_F(Rungs, TheNewOneHasANodeAheadOfEachInnerOneButThoseSkipped) {
    const StepInput in = bench.stepTo(bladeAt(-0.3, 0.1));
    PredicatePositions positions(in);
    const Strip strip = buildStrip(in, positions);
    const auto all = newRung(in, strip, {});
    ASSERT_GT(all.size(), 3U);
    for (const std::optional<StripNode>& node : all) {
        ASSERT_TRUE(node);
        EXPECT_LT((node->position - pointOn(in.blade, node->s)).norm(), 1e-12);
    }
    EXPECT_EQ(newRung(in, strip, {all[1]->s}).size(), all.size() - 1);
}

TEST_F(Rungs, AnEndThatIsHeldStaysAtTheOldOne) {
    StepInput in = bench.stepTo(bladeAt(-0.3, 0.1));
    in.span.holdsFrom = true;
    PredicatePositions positions(in);
    const Strip strip = buildStrip(in, positions);
    EXPECT_EQ(strip.newRung.front(), 0);
    EXPECT_FALSE(strip.isOld(strip.newRung.back()));
}

TEST_F(Rungs, PlacesBetweenThemAreFoundInTheStrip) {
    const StepInput in = bench.stepTo(bladeAt(-0.3, 0.1));
    PredicatePositions positions(in);
    const Strip strip = buildStrip(in, positions);
    const StripLocator places(in.blade, strip);
    for (const Triangle& t : strip.triangles) {
        Vec2 layout = Vec2::Zero();
        Vec3 position = Vec3::Zero();
        for (const int node : t) {
            layout += strip.nodes[node].layout / 3;
            position += strip.nodes[node].position / 3;
        }
        EXPECT_LT((places.at(layout) - position).norm(), 1e-12);
    }
    EXPECT_EQ(test::reasonOf([&] {
                  places.at({-1, 0});
              }),
              "an inner wall point lies outside the strip");
}

}  // namespace
}  // namespace kerf::cut

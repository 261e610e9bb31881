#include "sim/cut/plan/wall/loops.h"

#include <gtest/gtest.h>

#include <random>

#include "sim/cut/plan/wall/ears.h"
#include "tests/support/drawn_outline.h"
#include "tests/support/fuzz_seed.h"
#include "tests/support/step_bench.h"

namespace kerf::cut {
namespace {

constexpr double kH = 1;

class Loops : public ::testing::Test, protected test::DrawnOutline {
  protected:
    Loops() { bench.begin(test::bladeAt(2, 0.25)); }

    std::vector<Sheet2d> nest() {
        return nestLoops(bench.stepTo(test::bladeAt(-2, 0.25)), outline, curves.nodes);
    }
    double areaOf(const Loop& loop) const { return test::layoutArea(curves.nodes, loop); }

    test::StepBench bench{test::unitTetrahedron(), kH};
};

TEST_F(Loops, KeepTheirEdgesInTurn) {
    loop(square(1, 2));
    std::rotate(outline.edges.begin(), outline.edges.begin() + 2, outline.edges.end());
    std::swap(outline.edges[0], outline.edges[1]);
    const std::vector<Sheet2d> sheets = nest();
    ASSERT_EQ(sheets.size(), 1U);
    const Loop& outer = sheets.front().outer;
    ASSERT_EQ(outer.size(), 4U);
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(outer[i].to, outer[(i + 1) % 4].from);
    }
}

TEST_F(Loops, AHoleBelongsToTheSmallestLoopAroundIt) {
    loop(square(1, 3));
    loop(turned(square(1.5, 2.5)));
    loop(square(0, 4));
    loop(turned(square(0.5, 3.5)));
    const std::vector<Sheet2d> sheets = nest();
    ASSERT_EQ(sheets.size(), 2U);
    for (const Sheet2d& sheet : sheets) {
        ASSERT_EQ(sheet.holes.size(), 1U);
    }
    EXPECT_DOUBLE_EQ(areaOf(sheets[0].holes[0]), -1);
    EXPECT_DOUBLE_EQ(areaOf(sheets[1].holes[0]), -9);
}

// Two squares that share a corner: each is a loop of its own, not one that crosses itself.
TEST_F(Loops, ThatMeetAtANodeComeApart) {
    const int shared = node({2, 2});
    loopThrough({node({1, 1}), node({2, 1}), shared, node({1, 2})});
    loopThrough({shared, node({3, 2}), node({3, 3}), node({2, 3})});
    const std::vector<Sheet2d> sheets = nest();
    ASSERT_EQ(sheets.size(), 2U);
    EXPECT_DOUBLE_EQ(areaOf(sheets[0].outer), 1);
    EXPECT_DOUBLE_EQ(areaOf(sheets[1].outer), 1);
}

TEST_F(Loops, AThinOneThatRunsClockwiseIsASheet) {
    loop({{1, 1}, {1, 1 + 1e-5}, {2, 1}});
    EXPECT_EQ(nest().size(), 1U);
}

TEST_F(Loops, ThatAreOpenOrHolesOfNothingAreRefused) {
    loop(turned(square(1, 2)));
    EXPECT_EQ(test::reasonOf([&] { nest(); }), "a hole of the wall has no loop around it");
    outline.edges.pop_back();
    EXPECT_EQ(test::reasonOf([&] { nest(); }), "a loop of the wall is open");
}

class Ears : public Loops {
  protected:
    /// Cuts the ears of all sheets: each border edge once, none inside twice the same way.
    std::vector<Triangle> cutAll() {
        std::vector<Triangle> all;
        std::set<std::pair<int, int>> edges;
        for (const Sheet2d& sheet : nest()) {
            for (const Triangle& t : cutEars(sheet, curves.nodes, kH)) {
                all.push_back(t);
                for (int e = 0; e < 3; ++e) {
                    EXPECT_TRUE(edges.insert({t[e], t[(e + 1) % 3]}).second) << "twice";
                }
            }
        }
        for (const OutlineEdge& edge : outline.edges) {
            EXPECT_EQ(edges.count({edge.from, edge.to}), 1U);
            EXPECT_EQ(edges.count({edge.to, edge.from}), 0U);
        }
        return all;
    }
    void expectCovered(int triangles) {
        const std::vector<Triangle> all = cutAll();
        EXPECT_EQ(sizeOf(all), triangles);
        double area = 0;
        for (const Triangle& t : all) {
            EXPECT_GT(test::doubleLayoutArea(curves.nodes, t), -1e-12);
            area += 0.5 * test::doubleLayoutArea(curves.nodes, t);
        }
        EXPECT_NEAR(area, test::layoutArea(curves.nodes, outline.edges), 1e-12);
    }
};

TEST_F(Ears, OfASquareAreTwo) {
    loop(square(1, 2));
    expectCovered(2);
}

TEST_F(Ears, GoAroundACornerInwards) {
    loop({{1, 1}, {3, 1}, {3, 1.2}, {1.2, 1.2}, {1.2, 3}, {1, 3}});
    expectCovered(4);
}

TEST_F(Ears, GoAroundHoles) {
    loop(square(0, 4));
    loop(turned(square(0.5, 1)));
    loop(turned(square(2, 3)));
    expectCovered(4 + 4 + 4 + 2 * 2 - 2);
}

TEST_F(Ears, OfTwoEdgesAreRefused) {
    loop({{1, 1}, {2, 1}});
    EXPECT_EQ(test::reasonOf([&] { cutAll(); }), "a loop of the wall has two edges");
}

TEST_F(Ears, CoverStarsOfAnyShape) {
    const std::uint32_t seed = test::fuzzSeed(101);
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random{seed};
    std::uniform_real_distribution<double> uniform{0.2, 1.8};
    for (int i = 0; i < 100; ++i) {
        outline = {};
        curves.nodes.clear();
        const int corners = 3 + static_cast<int>(random() % 20);
        Points star;
        for (int k = 0; k < corners; ++k) {
            const double angle = 2 * M_PI * k / corners;
            star.emplace_back(Vec2(2, 2) +
                              uniform(random) * Vec2(std::cos(angle), std::sin(angle)));
        }
        loop(star);
        expectCovered(corners - 2);
    }
}

}  // namespace
}  // namespace kerf::cut

#include "sim/cut/blade.h"
#include "sim/cut/plan/curves/curve_nodes.h"
#include "sim/cut/plan/curves/inside_out.h"
#include "sim/cut/plan/curves/intersections.h"
#include "sim/cut/plan/strip/new_rung.h"
#include "sim/cut/plan/strip/strip.h"
#include "sim/cut/plan/wall/sheet_border.h"

namespace kerf::cut {
namespace {

/// A box that has been cut half through.
class Rungs : public ::testing::Test {
  protected:
    Rungs() {
        bench.begin(bladeAt(1, 0.1));
        bench.cutTo(bladeAt(0, 0.1));
    }
    StepBench bench{box(), 0.25};
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
    EXPECT_EQ(reasonOf([&] { places.at({-1, 0}); }), "an inner wall point lies outside the strip");
}

/// A blade that comes into a box from the air.
class InsideOutOfAStrip : public ::testing::Test {
  protected:
    InsideOutOfAStrip() {
        bench.begin(bladeAt(1, 0.1));
        PredicatePositions positions(in());
        strip = buildStrip(in(), positions);
        curves = intersect(in(), strip, positions);
        points = borderPoints(in(), strip, in().pieceOfVertex[0], curves, curves.segments);
    }
    StepInput in() { return bench.stepTo(bladeAt(0, 0.1)); }
    int inside(const std::vector<BorderPoint>& told) {
        return static_cast<int>(std::ranges::count(told, true, &BorderPoint::inside));
    }

    StepBench bench{box(), 0.25};
    Strip strip;
    CutCurves curves;
    std::vector<BorderPoint> points;
};

TEST_F(InsideOutOfAStrip, TheBorderEntersTheBodyOnceAndLeavesIt) {
    EXPECT_EQ(std::ranges::count(points, 1, &BorderPoint::event), 1);
    EXPECT_EQ(std::ranges::count(points, -1, &BorderPoint::event), 1);
    const auto told = tellInsideOut(in(), strip, points);
    EXPECT_EQ(inside(told), 1) << "the part of the blade between the two";
    const auto entry = std::ranges::find(told, true, &BorderPoint::inside);
    EXPECT_EQ(entry->event, 1);
    EXPECT_TRUE(strip.onNewRung(entry->edge));
}

TEST_F(InsideOutOfAStrip, WithoutCurvesAllLiesOutside) {
    for (BorderPoint& point : points) {
        point.event = 0;
    }
    EXPECT_EQ(inside(tellInsideOut(in(), strip, points)), 0);
}

TEST_F(InsideOutOfAStrip, EndsInAnOrderThatCannotBeAreSwappedWhereTheyLieClose) {
    const auto entry = std::ranges::find(points, 1, &BorderPoint::event);
    ASSERT_NE(entry + 1, points.end());
    entry->event = -1;
    (entry + 1)->event = 1;
    EXPECT_EQ(reasonOf([&] { tellInsideOut(in(), strip, points); }),
              "the blade's border enters the body twice");
    (entry + 1)->u = entry->u + 0.01;
    EXPECT_EQ(inside(tellInsideOut(in(), strip, points)), 1);
}

/// A sheet with corners in the layout plane, counter-clockwise.
struct Drawn {
    explicit Drawn(const std::vector<Vec2>& corners) {
        for (const Vec2& p : corners) {
            nodes.emplace_back().layout = p;
        }
        for (int i = 0; i < sizeOf(nodes); ++i) {
            sheet.outer.push_back({i, (i + 1) % sizeOf(nodes), OutlineKind::cut, 0});
        }
    }
    double areaOf(const std::vector<Triangle>& triangles) const {
        double area = 0;
        for (const Triangle& t : triangles) {
            area += 0.5 * doubleLayoutArea(nodes, t);
        }
        return area;
    }
    std::vector<CutNode> nodes;
    Sheet2d sheet;
};

TEST(SheetBorder, TheInsideIsTriangulatedAndNothingElse) {
    const Drawn drawn({{0, 0}, {2, 0}, {2, 2}, {1, 1}, {0, 2}});
    const BorderedSheet sheet(drawn.sheet, drawn.nodes, 5, 1);
    EXPECT_EQ(sheet.triangles().size(), 3U);
    EXPECT_NEAR(drawn.areaOf(sheet.triangles()), 3, 1e-12);
    EXPECT_EQ(sheet.bounds().high, Vec2(2, 2));
}

TEST(SheetBorder, AnInnerNodeGetsTheNumberGiven) {
    const Drawn drawn({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
    BorderedSheet sheet(drawn.sheet, drawn.nodes, 40, 1);
    const Vec2 middle(0.9, 1.1);
    sheet.addInner(middle, Vec3(1, 2, 3), sheet.plane().locate(middle));
    ASSERT_EQ(sheet.inner().size(), 1U);
    EXPECT_EQ(sheet.inner().front().position, Vec3(1, 2, 3));
    const std::vector<Triangle> triangles = sheet.triangles();
    EXPECT_EQ(triangles.size(), 4U);
    for (const Triangle& t : triangles) {
        EXPECT_EQ(std::ranges::count(t, 40), 1);
    }
}

// Two corners at one place but for rounding: each triangle there takes the one whose edges bound
// it.
TEST(SheetBorder, NodesAtOnePlaceKeepTheirOwnTriangles) {
    const Drawn drawn({{1, 1}, {0, 2}, {0, 0}, {1 + 1e-14, 1}, {2, 0}, {2, 2}});
    const BorderedSheet sheet(drawn.sheet, drawn.nodes, 6, 1);
    const std::vector<Triangle> triangles = sheet.triangles();
    ASSERT_EQ(triangles.size(), 2U);
    for (const Triangle& t : triangles) {
        EXPECT_EQ(std::ranges::count(t, 0) + std::ranges::count(t, 3), 1);
    }
    EXPECT_NE(std::ranges::count(triangles[0], 0), std::ranges::count(triangles[1], 0));
}

TEST(SheetBorder, ABorderThatCrossesItselfIsRefused) {
    const Drawn drawn({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
    EXPECT_EQ(reasonOf([&] { BorderedSheet(drawn.sheet, drawn.nodes, 4, 1); }),
              "the border of the wall crosses itself");
}

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
    EXPECT_EQ(reasonOf([&] { meshEdgeCrossing(pair, *signs, 0); }),
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

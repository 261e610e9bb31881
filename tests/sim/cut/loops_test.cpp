#include "sim/cut/plan/wall/loops.h"

#include "sim/cut/plan/air_edges.h"
#include "sim/cut/plan/wall/ears.h"
#include "tests/support/drawn_outline.h"

namespace kerf::cut {
namespace {

constexpr double kUnitEdge = 1;

class Loops : public ::testing::Test, protected DrawnOutline {
  protected:
    Loops() { bench.begin(bladeAt(2, 0.25)); }

    std::vector<Sheet2d> nest() {
        return nestLoops(bench.stepTo(bladeAt(-2, 0.25)), outline, curves.nodes);
    }
    double areaOf(const Loop& loop) const { return layoutArea(curves.nodes, loop); }

    StepBench bench{unitTetrahedron(), kUnitEdge};
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
    EXPECT_EQ(reasonOf([&] { nest(); }), "a hole of the wall has no loop around it");
    outline.edges.pop_back();
    EXPECT_EQ(reasonOf([&] { nest(); }), "a loop of the wall is open");
}

class Ears : public Loops {
  protected:
    /// Cuts the ears of all sheets: each border edge once, none inside twice the same way.
    std::vector<Triangle> cutAll() {
        std::vector<Triangle> all;
        std::set<std::pair<int, int>> edges;
        for (const Sheet2d& sheet : nest()) {
            for (const Triangle& t : cutEars(sheet, curves.nodes, kUnitEdge)) {
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
            EXPECT_GT(doubleLayoutArea(curves.nodes, t), -1e-12);
            area += 0.5 * doubleLayoutArea(curves.nodes, t);
        }
        EXPECT_NEAR(area, layoutArea(curves.nodes, outline.edges), 1e-12);
    }
};

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

TEST_F(Ears, CoverStarsOfAnyShape) {
    const std::uint32_t seed = fuzzSeed(101);
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

constexpr double kEdge = 0.3;
const Vec3 kShift(0.02, 0.15, -0.01);

/// A box of size 1 about the origin, and a rung along x above its top, all in the air.
class AirTiesOfABox : public ::testing::Test {
  protected:
    static std::vector<RungNode> rungAt(double height) {
        const double y = 0.5 + height;
        return {{{-0.3, y, 0.01}, 0, -1, false}, {{0.3, y, 0.01}, 1, -1, false}};
    }
    AirTies tiesOf(const std::vector<RungNode>& rung, SkinShape shape = SkinShape::current) {
        TriangleTree tree(mesh);
        return {mesh, tree, [](int) { return true; }, kEdge, rung, shape};
    }
    void move(const Vec3& way) {
        for (int v = 0; v < mesh.vertexCount(); ++v) {
            mesh.setPosition(v, mesh.position(v) + way);
        }
    }
    /// How much of the way of the skin a rung goes that is so high above it.
    double shareAt(double height) {
        std::vector<RungNode> rung = rungAt(height);
        const std::vector<RungNode> before = rung;
        const AirTies ties = tiesOf(rung);
        move(kShift);
        ties.follow(mesh, rung);
        move(-kShift);
        for (std::size_t i = 0; i < rung.size(); ++i) {
            const Vec3 way = rung[i].position - before[i].position;
            EXPECT_NEAR(way.cross(kShift).norm(), 0, 1e-12);
        }
        return (rung[0].position - before[0].position).dot(kShift) / kShift.squaredNorm();
    }

    SurfaceMesh mesh = box(Vec3::Ones(), 3);
};

TEST_F(AirTiesOfABox, GoWithTheSkinTheLessTheFartherOffItIs) {
    EXPECT_NEAR(shareAt(0.1 * kEdge), 1, 1e-9);
    EXPECT_NEAR(shareAt(0.99 * kEdge), 1, 1e-9);
    EXPECT_NEAR(shareAt(1.75 * kEdge), 0.5, 1e-9);
    EXPECT_NEAR(shareAt(2.6 * kEdge), 0, 1e-9);
}

TEST_F(AirTiesOfABox, LeaveVerticesToTheMesh) {
    std::vector<RungNode> rung = rungAt(0.1);
    rung[1].vertex = 5;
    const Vec3 before = rung[1].position;
    const AirTies ties = tiesOf(rung);
    move(kShift);
    ties.follow(mesh, rung);
    EXPECT_EQ(rung[1].position, before);
    EXPECT_NE(rung[0].position, rungAt(0.1)[0].position);
}

TEST_F(AirTiesOfABox, CarryPointsBetweenTheNodes) {
    const AirTies ties = tiesOf(rungAt(0.1));
    move(kShift);
    const std::vector<CarriedPoint> points = ties.between(mesh, 0);
    ASSERT_EQ(points.size(), 6U) << "0.3 h apart";
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Vec3 wanted(-0.3 + 0.6 * static_cast<double>(k + 1) / 7, 0.6, 0.01);
        EXPECT_LT((points[k].position - wanted - kShift).norm(), 1e-12);
        EXPECT_LT((points[k].outward - Vec3::UnitY()).norm(), 1e-12);
    }
}

TEST_F(AirTiesOfABox, OfAPartAreThoseOfItsEdges) {
    std::vector<RungNode> rung = rungAt(0.1);
    rung.insert(rung.begin() + 1, {{0, 0.6, 0.01}, 0.5, -1, false});
    const AirTies part = tiesOf(rung).part(1, 2, 4);
    EXPECT_TRUE(part.between(mesh, 0).empty());
    EXPECT_TRUE(part.between(mesh, 1).empty());
    ASSERT_EQ(part.between(mesh, 4).size(), 3U);
    EXPECT_GT(part.between(mesh, 4).front().position.x(), 0);
}

TEST_F(AirTiesOfABox, FrontEdgesAndGapsInTheFrontHaveNone) {
    std::vector<RungNode> rung = rungAt(0.1);
    std::vector<int> vertices;
    rung[0].attached = true;
    tiesOf(rung).addVertices(vertices);
    rung[0] = {rung[0].position, 0, 3, false};
    rung[1].vertex = 5;
    tiesOf(rung).addVertices(vertices);
    EXPECT_TRUE(vertices.empty());
}

// The body had moved before anybody asked.
TEST_F(AirTiesOfABox, AtRestHoldTheRungToWhereTheSkinRests) {
    std::vector<RungNode> rung = rungAt(0.1);
    move(kShift);
    tiesOf(rung, SkinShape::rest).follow(mesh, rung);
    EXPECT_LT((rung[0].position - rungAt(0.1)[0].position - kShift).norm(), 1e-12);
}

/// A rung above a box whose top may come up through it.
class AirEdgesAboveABox : public ::testing::Test {
  protected:
    /// The rung once it has been led around what has risen by so much.
    std::vector<RungNode> clearedAfter(double rise) {
        const Blade blade{{-0.8, 0.6, 0.01}, {0.8, 0.6, 0.02}};
        bench.begin(blade);
        TriangleTree tree(bench.mesh);
        const AirTies ties(
            bench.mesh, tree, [](int) { return true; }, kEdge, bench.rung(), SkinShape::current);
        for (int v = 0; v < bench.mesh.vertexCount(); ++v) {
            bench.mesh.setPosition(v, bench.mesh.position(v) + Vec3(0, rise, 0));
        }
        const Blade to{{-0.8, 0.3, 0.01}, {0.8, 0.3, 0.02}};
        const StepInput in = bench.stepTo(to);
        std::vector<RungNode> rung = in.rung;
        const auto give = [&]() -> const AirTies& {
            asked = true;
            return ties;
        };
        clearAirEdges(bench.mesh, in.broadPhase, in.opening, to, kEdge, give, rung);
        return rung;
    }
    bool isPierced(const std::vector<RungNode>& rung) const {
        const std::vector<int> living = livingTriangles(bench.mesh);
        for (std::size_t i = 0; i + 1 < rung.size(); ++i) {
            const auto goesThrough = [&](int t) {
                return pierces(rung[i].position, rung[i + 1].position, cornersOf(bench.mesh, t));
            };
            if (std::ranges::any_of(living, goesThrough)) {
                return true;
            }
        }
        return false;
    }

    StepBench bench{box(Vec3::Ones(), 3), kEdge};
    bool asked = false;
};

TEST_F(AirEdgesAboveABox, StayWhereNothingIsInTheWay) {
    const std::vector<RungNode> rung = clearedAfter(0.05);
    EXPECT_EQ(rung.size(), 2U);
    EXPECT_FALSE(asked) << "for ties that are not needed";
}

TEST_F(AirEdgesAboveABox, GoAroundSkinThatHasRisenThroughThem) {
    const std::vector<RungNode> rung = clearedAfter(0.2);
    EXPECT_TRUE(asked);
    ASSERT_GT(rung.size(), 2U);
    EXPECT_TRUE(isPierced({rung.front(), rung.back()}));
    EXPECT_FALSE(isPierced(rung));
    EXPECT_EQ(rung.front().position, Vec3(-0.8, 0.6, 0.01));
    EXPECT_EQ(rung.back().position, Vec3(0.8, 0.6, 0.02));
    for (std::size_t i = 0; i + 1 < rung.size(); ++i) {
        EXPECT_LT(rung[i].s, rung[i + 1].s);
        EXPECT_FALSE(rung[i].attached || rung[i].vertex >= 0);
    }
}

constexpr int kStroke = 1;
constexpr int kPlus = 0;   ///< triangle of its wall W+
constexpr int kMinus = 1;  ///< of W-
constexpr int kSkin = 2;

/// One triangle of each kind; leavesBridge asks for labels alone.
SurfaceMesh oneTriangleEach() {
    SurfaceMesh mesh;
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}) {
        mesh.addVertex(p, p, Vec3::Zero());
    }
    mesh.addTriangle({0, 1, 2}, SurfaceKind::wall, 2 * kStroke);
    mesh.addTriangle({0, 2, 1}, SurfaceKind::wall, 2 * kStroke + 1);
    mesh.addTriangle({0, 1, 2}, SurfaceKind::skin, -1);
    return mesh;
}

/// A new wall from the old rung at y = 0 on, in a loop of its own.
class Plan {
  public:
    /// The start in the material, curves in these triangles, and the new front, if there is one.
    Plan& loop(bool starts, const std::vector<int>& triangles, bool hasFront, int piece = 0) {
        const int first = sizeOf(plan_.curves.nodes);
        int last = node(0);
        if (starts) {
            last = edge(last, node(0), OutlineKind::free, piece);
        }
        for (const int t : triangles) {
            plan_.curves.segments.push_back({t, 0, last, sizeOf(plan_.curves.nodes)});
            last = edge(last, node(0.5), OutlineKind::cut, piece);
        }
        if (hasFront) {
            const int end = node(1);
            plan_.outline.front = {{1, last, true}, {0, end, false}};
            last = edge(last, end, OutlineKind::free, piece);
        }
        edge(last, first, OutlineKind::cut, piece);
        return *this;
    }

    bool leavesBridge() const { return cut::leavesBridge(oneTriangleEach(), kStroke, {0}, plan_); }

  private:
    int node(double y) {
        CutNode node;
        node.layout = {0, y};
        plan_.curves.nodes.push_back(node);
        return sizeOf(plan_.curves.nodes) - 1;
    }

    int edge(int from, int to, OutlineKind kind, int piece) {
        plan_.outline.edges.push_back({from, to, kind, piece});
        return to;
    }

    StepPlan plan_;
};

TEST(Bridges, AreLeftUnlessTheNewWallsCrossTheOldOnesAllAlong) {
    const std::vector<int> skin{kSkin}, plus{kPlus}, minus{kMinus}, both{kPlus, kMinus};
    EXPECT_FALSE(Plan().loop(true, {kSkin, kPlus}, false).loop(false, minus, true).leavesBridge());
    EXPECT_FALSE(Plan().loop(true, plus, false).loop(true, skin, true, 1).leavesBridge())
        << "a piece without the front";
    for (const bool hasFront : {false, true}) {
        EXPECT_TRUE(Plan().loop(true, both, hasFront).leavesBridge()) << "around their end";
        EXPECT_TRUE(Plan().loop(true, skin, hasFront).leavesBridge()) << "past them";
        EXPECT_TRUE(Plan().loop(true, plus, false).loop(true, minus, hasFront).leavesBridge())
            << "a start on both sides";
    }
}

TEST(Bridges, ThePiecesOfARungAreThoseOfItsFrontEdges) {
    const std::vector<int> pieceOfVertex{4, 4, 7, 9};
    const std::vector<RungNode> rung{{Vec3::Zero(), 0.0, -1, false}, {Vec3::Zero(), 0.2, 0, true},
                                     {Vec3::Zero(), 0.4, 1, false},  {Vec3::Zero(), 0.5, 2, true},
                                     {Vec3::Zero(), 0.6, 2, false},  {Vec3::Zero(), 0.8, 3, false}};
    EXPECT_EQ(piecesOfFront(rung, pieceOfVertex), (std::set<int>{4, 7}));
}

}  // namespace
}  // namespace kerf::cut

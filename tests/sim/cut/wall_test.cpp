#include "sim/cut/plan/wall/wall.h"

#include "tests/support/drawn_outline.h"

namespace kerf::cut {
namespace {

using Directed = std::set<std::pair<int, int>>;

Directed edgesOf(const std::vector<WallSheet>& sheets) {
    Directed edges;
    for (const WallSheet& sheet : sheets) {
        for (const Triangle& t : sheet.triangles) {
            for (int e = 0; e < 3; ++e) {
                EXPECT_TRUE(edges.insert({t[e], t[(e + 1) % 3]}).second) << "an edge twice";
            }
        }
    }
    return edges;
}

int triangleCount(const std::vector<WallSheet>& sheets) {
    int count = 0;
    for (const WallSheet& sheet : sheets) {
        count += sizeOf(sheet.triangles);
    }
    return count;
}

/// The triangles cover the inside of the outline once, and nothing else.
void expectCovers(const Outline& outline, const std::vector<WallSheet>& sheets,
                  const std::vector<CutNode>& nodes) {
    double area = 0;
    for (const WallSheet& sheet : sheets) {
        for (const Triangle& t : sheet.triangles) {
            const double doubleArea = doubleLayoutArea(nodes, t);
            EXPECT_GT(doubleArea, -1e-12) << "clockwise";
            area += 0.5 * doubleArea;
        }
    }
    EXPECT_NEAR(area, layoutArea(nodes, outline.edges), 1e-9);
    const Directed edges = edgesOf(sheets);
    Directed border;
    std::ranges::copy_if(edges, std::inserter(border, border.end()), [&](const auto& edge) {
        return edges.count({edge.second, edge.first}) == 0;
    });
    Directed wanted;
    for (const OutlineEdge& edge : outline.edges) {
        wanted.insert({edge.from, edge.to});
    }
    EXPECT_EQ(border, wanted);
}

/// Inner nodes lie in the strip, where their place in the layout plane says.
void expectInStrip(const Strip& strip, const std::vector<CutNode>& nodes, std::size_t first) {
    for (std::size_t i = first; i < nodes.size(); ++i) {
        EXPECT_EQ(nodes[i].kind, NodeKind::wall);
        const std::optional<Vec3> place = placeInStrip(strip, nodes[i].layout);
        ASSERT_TRUE(place.has_value());
        EXPECT_LT((*place - nodes[i].position).norm(), 1e-9);
    }
}

/// Edges that lie in a face of the mesh, which would close a chip of no thickness.
int chordsOf(const SurfaceMesh& mesh, const Outline& outline, const std::vector<WallSheet>& sheets,
             const std::vector<CutNode>& nodes) {
    std::set<Edge> border;
    for (const OutlineEdge& edge : outline.edges) {
        border.insert(edgeOf(edge.from, edge.to));
    }
    const auto facesOf = [&](const CutNode& node) {
        std::set<int> faces;
        if (node.kind == NodeKind::face) {
            faces = {node.a};
        } else if (node.kind == NodeKind::edge) {
            const int h = mesh.findHalfEdge(node.a, node.b);
            faces = {h / 3, mesh.twin(h) / 3};
        }
        return faces;
    };
    int chords = 0;
    for (const auto& [from, to] : edgesOf(sheets)) {
        const std::set<int> faces = facesOf(nodes[to]);
        chords += border.count(edgeOf(from, to)) == 0 &&
                  std::ranges::any_of(facesOf(nodes[from]), [&](int f) { return faces.count(f); });
    }
    return chords;
}

/// Outlines drawn in the layout plane of a strip of 4 by 4, with edges of length 1.
class WallOfADrawing : public ::testing::Test, protected DrawnOutline {
  protected:
    WallOfADrawing() { bench.begin(bladeAt(2, 0.25)); }

    std::vector<WallSheet> triangulate() {
        const StepInput in = bench.stepTo(bladeAt(-2, 0.25));
        PredicatePositions positions(in);
        strip = buildStrip(in, positions);
        Wall wall = triangulateWall(in, strip, outline, curves);
        curves.append(wall.nodes);
        return std::move(wall.sheets);
    }

    std::vector<WallSheet> expectTriangles(int count) {
        std::vector<WallSheet> sheets = triangulate();
        expectCovers(outline, sheets, curves.nodes);
        EXPECT_EQ(triangleCount(sheets), count);
        return sheets;
    }

    std::string reason() {
        return reasonOf([&] { triangulate(); });
    }

    void putOnFace(int node) {
        curves.nodes[node].kind = NodeKind::face;
        curves.nodes[node].a = 3;
    }
    static Points dividedSquare(double low, double high, int parts) {
        Points points;
        const Points corners = square(low, high);
        for (int side = 0; side < 4; ++side) {
            const Vec2 way = (corners[(side + 1) % 4] - corners[side]) / parts;
            for (int i = 0; i < parts; ++i) {
                points.emplace_back(corners[side] + i * way);
            }
        }
        return points;
    }

    StepBench bench{unitTetrahedron(), 1};
    Strip strip;
};

TEST_F(WallOfADrawing, ALowSheetIsDividedAtItsBorderAlone) {
    for (const auto& [name, points, triangles] : std::vector<std::tuple<const char*, Points, int>>{
             {"a corner inwards", {{1, 1}, {2, 1}, {2, 1.4}, {1.4, 1.4}, {1.4, 2}, {1, 2}}, 4},
             {"points in a row", {{1, 1}, {1.3, 1}, {1.7, 1}, {2, 1}, {2, 2}, {1, 2}}, 4},
             {"a long one",
              {{0.5, 1}, {1.5, 1}, {2.5, 1}, {3.5, 1}, {3.5, 2}, {2.5, 2}, {1.5, 2}, {0.5, 2}},
              6}}) {
        SCOPED_TRACE(name);
        outline = {};
        curves.nodes.clear();
        loop(points);
        expectTriangles(triangles);
    }
}

TEST_F(WallOfADrawing, AHoleStaysOpen) {
    loop(square(1, 2.15));
    loop(turned(square(1.3, 1.7)));
    EXPECT_EQ(expectTriangles(8).size(), 1U);
}

TEST_F(WallOfADrawing, LoopsBesideEachOtherAreSheetsOfTheirOwn) {
    loop(square(0.5, 1.5), 4);
    loop(square(2, 3), 7);
    const std::vector<WallSheet> sheets = expectTriangles(4);
    ASSERT_EQ(sheets.size(), 2U);
    EXPECT_EQ(sheets[0].piece, 4);
    EXPECT_EQ(sheets[1].piece, 7);
}

// A hole belongs to the smallest loop of its own piece around it.
TEST_F(WallOfADrawing, LoopsOfDifferentPiecesDoNotSeeEachOther) {
    loop(square(1, 2.15), 4);
    loop(square(1.3, 1.7), 7);
    EXPECT_EQ(expectTriangles(4).size(), 2U);
}

// Two sides of an older slit: the same place, with a node for either side.
TEST_F(WallOfADrawing, NodesAtOnePlaceStayApart) {
    const int first = loop({{1, 1}, {2, 1}, {2, 1.5}, {1.5, 1.5}, {2, 1.5}, {2, 2}, {1, 2}});
    const std::vector<WallSheet> sheets = expectTriangles(5);
    const Directed edges = edgesOf(sheets);
    EXPECT_TRUE(edges.count({first + 1, first + 2}) > 0);
    EXPECT_TRUE(edges.count({first + 4, first + 5}) > 0);
}

double distanceTo(const std::vector<CutNode>& nodes, const OutlineEdge& edge, const Vec2& p) {
    const Vec2& a = nodes[edge.from].layout;
    const Vec2 way = nodes[edge.to].layout - a;
    return (a + std::clamp((p - a).dot(way) / way.squaredNorm(), 0.0, 1.0) * way - p).norm();
}

// About one edge length from each other, and not much less from the border.
TEST_F(WallOfADrawing, TallSheetsGetNodesInside) {
    for (const double size : {2.2, 2.5, 2.8, 3.1, 3.4}) {
        SCOPED_TRACE(size);
        outline = {};
        curves.nodes.clear();
        const int border = loop(dividedSquare(0.3, 0.3 + size, 3)) + 4 * 3;
        const std::vector<WallSheet> sheets = triangulate();
        expectCovers(outline, sheets, curves.nodes);
        expectInStrip(strip, curves.nodes, border);
        EXPECT_GT(sizeOf(curves.nodes), border);
        for (int i = border; i < sizeOf(curves.nodes); ++i) {
            const Vec2& p = curves.nodes[i].layout;
            for (const OutlineEdge& edge : outline.edges) {
                EXPECT_GT(distanceTo(curves.nodes, edge, p), 0.39);
            }
            for (int k = border; k < i; ++k) {
                EXPECT_GT((curves.nodes[k].layout - p).norm(), 0.99);
            }
        }
        for (const auto& [from, to] : edgesOf(sheets)) {
            EXPECT_LT((curves.nodes[to].layout - curves.nodes[from].layout).norm(), 1.8);
        }
    }
}

// Three nodes of one face: without a flip the edge from the first to the last would lie in it.
TEST_F(WallOfADrawing, AnEdgeBetweenNodesOfOneFaceIsTurned) {
    loop({{1, 1}, {2, 1}, {2, 2}, {1.5, 3}, {1, 2}});
    for (const int node : {2, 3, 4}) {
        putOnFace(node);
    }
    EXPECT_EQ(chordsOf(bench.mesh, outline, expectTriangles(3), curves.nodes), 0);
}

// Either diagonal would lie in the face.
TEST_F(WallOfADrawing, WhereNoFlipHelpsAnInnerNodeLeadsTheWallAway) {
    loop(square(1, 2));
    for (const int node : {0, 1, 2, 3}) {
        putOnFace(node);
    }
    EXPECT_EQ(chordsOf(bench.mesh, outline, expectTriangles(4), curves.nodes), 0);
    EXPECT_EQ(curves.nodes.size(), 5U);
    expectInStrip(strip, curves.nodes, 4);
}

// Whichever diagonal there is, one of its triangles is twice as large as the other.
TEST_F(WallOfADrawing, TheWiderTriangleTakesTheInnerNode) {
    for (const bool wideOnTheLeft : {true, false}) {
        outline = {};
        curves.nodes.clear();
        loop(wideOnTheLeft ? Points{{1, 1}, {2, 1}, {2, 2}, {1, 3}}
                           : Points{{1, 1}, {2, 1}, {2, 3}, {1, 2}});
        for (const int node : {0, 1, 2, 3}) {
            putOnFace(node);
        }
        expectTriangles(4);
        ASSERT_EQ(curves.nodes.size(), 5U);
        EXPECT_NEAR(curves.nodes[4].layout.x(), wideOnTheLeft ? 4.0 / 3 : 5.0 / 3, 1e-9);
    }
}

// Not a valid polygon: ears are cut instead, which keep each border edge.
TEST_F(WallOfADrawing, ABorderThatCrossesItselfIsStillFilled) {
    loop({{1, 1}, {2.1, 1}, {2.1, 2}, {1.5, 0.9}, {1, 2}});
    const std::vector<WallSheet> sheets = triangulate();
    EXPECT_EQ(triangleCount(sheets), 3);
    const Directed edges = edgesOf(sheets);
    for (const OutlineEdge& edge : outline.edges) {
        EXPECT_TRUE(edges.count({edge.from, edge.to}) > 0);
    }
}

TEST_F(WallOfADrawing, TwoEdgesOrAHoleInAnotherPieceAreRefused) {
    loop(square(1, 2.15), 4);
    loop(turned(square(1.3, 1.7)), 7);
    EXPECT_EQ(reason(), "a hole of the wall has no loop around it");
    outline = {};
    loop({{1, 1}, {2, 1}});
    EXPECT_EQ(reason(), "a loop of the wall has two edges");
}

TEST(Wall, RoundATorusHasAHole) {
    StepBench bench(torus(16, 8), 0.2);
    bench.begin({{-1, 0.01, 1}, {1, 0.02, 1}});
    const StepInput in = bench.stepTo({{-1, 0.01, -1}, {1, 0.02, -1}});
    const Stages stages = stagesOf(in);
    ASSERT_EQ(stages.sheets.size(), 1U);
    expectCovers(stages.outline, stages.sheets, stages.walled.nodes);
    EXPECT_NEAR(layoutArea(stages.walled.nodes, stages.outline.edges),
                M_PI * (0.5 * 0.5 - 0.2 * 0.2), 0.1);
}

TEST(Wall, OfRandomStepsCoversTheInsideOfTheOutline) {
    const std::uint32_t seed = fuzzSeed(71);
    SCOPED_TRACE("seed " + std::to_string(seed));
    int inner = 0;
    int chords = 0;
    int triangles = 0;
    const int steps = forRandomSteps(seed, 80, [&](const StepInput& in, const PlannedStep&) {
        const Stages stages = stagesOf(in);
        const std::vector<CutNode>& nodes = stages.walled.nodes;
        expectCovers(stages.outline, stages.sheets, nodes);
        expectInStrip(stages.strip, nodes, stages.seamed.nodes.size());
        inner += sizeOf(nodes) - sizeOf(stages.seamed.nodes);
        chords += chordsOf(in.mesh, stages.outline, stages.sheets, nodes);
        triangles += triangleCount(stages.sheets);
    });
    EXPECT_GT(steps, 130);
    EXPECT_GT(inner, 10);
    EXPECT_LT(chords, 1e-3 * triangles);
}

// W+ is W- turned over, triangle by triangle, on the same nodes.
TEST(Wall, BothWallsOfAPlanAreOneSheetFromTwoSides) {
    const std::uint32_t seed = fuzzSeed(72);
    SCOPED_TRACE("seed " + std::to_string(seed));
    forRandomSteps(seed, 20, [](const StepInput& in, const PlannedStep& step) {
        const std::vector<NewTriangle>& all = step.plan.triangles;
        const int walls = step.wallTriangles / 2;
        const int plus = sizeOf(all) - 2 * walls;
        ASSERT_EQ(plus, sizeOf(step.plan.subdivision.triangles));
        for (int i = plus; i < plus + walls; ++i) {
            const auto& [a, b, c] = all[i].corners;
            EXPECT_EQ(all[i + walls].corners, (Triangle{a, c, b}));
            EXPECT_EQ(all[i].side, CutSide::plus);
            EXPECT_EQ(all[i + walls].side, CutSide::minus);
            EXPECT_EQ(all[i].wallLabel, 2 * in.stroke);
            EXPECT_EQ(all[i + walls].wallLabel, 2 * in.stroke + 1);
        }
        EXPECT_LT(std::fabs(step.plan.volumeChange), 1e-12);
        EXPECT_LT(std::fabs(step.plan.restVolumeChange), 1e-12);
    });
}

}  // namespace
}  // namespace kerf::cut

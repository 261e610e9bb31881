#include "sim/cut/plan/curves/intersections.h"

namespace kerf::cut {
namespace {

constexpr double kNear = 1e-9;  // m: rounding in places that were found in two ways

/// Strip and curves of a step.
struct Met {
    Strip strip;
    CutCurves curves;
};

Met meet(const StepInput& in) {
    PredicatePositions positions(in);
    Met met;
    met.strip = buildStrip(in, positions);
    met.curves = intersect(in, met.strip, positions);
    return met;
}

std::array<Vec3, 3> stripCorners(const Strip& strip, int s) {
    const Triangle& t = strip.triangles[s];
    return {strip.nodes[t[0]].position, strip.nodes[t[1]].position, strip.nodes[t[2]].position};
}

bool triangleHas(const SurfaceMesh& mesh, int t, int v) {
    return std::ranges::count(mesh.triangle(t), v) > 0;
}

// The plane z = 0.25 meets the three edges to the top. The long strip keeps its diagonal away.
class MeetATetrahedron : public ::testing::Test {
  protected:
    StepBench bench{unitTetrahedron(), 1};

    Met meetAt(double from, double to) {
        bench.begin(bladeAt(from, 0.25));
        return meet(bench.stepTo(bladeAt(to, 0.25)));
    }
};

TEST_F(MeetATetrahedron, EdgesToTheTopGiveNodesAndFacesAroundItSegments) {
    const CutCurves curves = meetAt(2, -8).curves;
    ASSERT_EQ(curves.nodes.size(), 3U);
    const std::map<Edge, Vec3> wanted{
        {{0, 3}, Vec3(0, 0, 0.25)}, {{1, 3}, Vec3(0.75, 0, 0.25)}, {{2, 3}, Vec3(0, 0.75, 0.25)}};
    for (const auto& [edge, place] : wanted) {
        const std::vector<EdgeHit>& hits = curves.onEdge.at(edge);
        ASSERT_EQ(hits.size(), 1U);
        const CutNode& node = curves.nodes[hits.front().node];
        EXPECT_EQ(node.kind, NodeKind::edge);
        EXPECT_LT((node.position - place).norm(), 1e-15);
        EXPECT_LT((node.layout - Vec2(place.x() + 2, 2 - place.y())).norm(), 1e-12);
    }
    ASSERT_EQ(curves.segments.size(), 3U);
    EXPECT_EQ(curves.segmentsOfTriangle.size(), 3U);
    EXPECT_EQ(curves.segmentsOfTriangle.count(0), 0U) << "the bottom lies below";
    EXPECT_TRUE(curves.onFace.empty());
}

// From (-2, 2) to (2, -1) it passes x = 0 at y = 1/2, and y = 0 at x = 2/3.
TEST_F(MeetATetrahedron, TheDiagonalOfTheStripGivesNodesInTwoFaces) {
    const CutCurves curves = meetAt(2, -1).curves;
    ASSERT_EQ(curves.onFace.size(), 2U);
    EXPECT_EQ(curves.nodes.size(), 5U);
    EXPECT_EQ(curves.segments.size(), 5U);
    const std::map<int, Vec3> wanted{{2, Vec3(0, 0.5, 0.25)}, {1, Vec3(2.0 / 3, 0, 0.25)}};
    for (const auto& [key, id] : curves.onFace) {
        EXPECT_LT((curves.nodes[id].position - wanted.at(key.first)).norm(), 1e-15);
    }
}

// Folded along its diagonal, the strip meets the upright edge twice, its first triangle higher up.
TEST_F(MeetATetrahedron, NodesOfOneEdgeComeInTheOrderInWhichTheyLieOnIt) {
    bench.begin(bladeAt(2, 0.25));
    const StepInput in = bench.stepTo(bladeAt(-1, 0.25));
    PredicatePositions positions(in);
    Strip strip = buildStrip(in, positions);
    ASSERT_EQ(strip.triangles.front(), (Triangle{3, 2, 0}));
    strip.nodes[0].position = {-3, -1, 0.5};
    strip.nodes[1].position = {0.5, 3, 0.2};
    strip.nodes[2].position = {-0.5, 3, 0.8};
    strip.nodes[3].position = {3, -1, 0.5};
    const CutCurves curves = intersect(in, strip, positions);
    const std::vector<EdgeHit>& hits = curves.onEdge.at({0, 3});
    ASSERT_EQ(hits.size(), 2U);
    EXPECT_EQ(hits[0].stripTriangle, 1);
    EXPECT_NEAR(curves.nodes[hits[0].node].position.z(), 0.425, 1e-12);
    EXPECT_EQ(hits[1].stripTriangle, 0);
    EXPECT_NEAR(curves.nodes[hits[1].node].position.z(), 0.575, 1e-12);
}

TEST_F(MeetATetrahedron, AStripInTheAirMeetsNothing) {
    const CutCurves curves = meetAt(5, 4).curves;
    EXPECT_TRUE(curves.nodes.empty());
    EXPECT_TRUE(curves.segments.empty());
    EXPECT_TRUE(curves.segmentsOfTriangle.empty());
}

TEST(Intersections, DegenerateOnesAreRefused) {
    const auto reasonFor = [](const Blade& from, const Blade& to) {
        StepBench bench(unitTetrahedron(), 1);
        bench.begin(from);
        return reasonOf([&] { meet(bench.stepTo(to)); });
    };
    EXPECT_EQ(reasonFor({{-1, 2, 1}, {3, 2, -1}}, {{-1, -8, 1}, {3, -8, -1}}),
              "degenerate: a vertex lies on a triangle");
    EXPECT_EQ(reasonFor({{-2, -2, 0.25}, {2, 2, 0.25}}, {{1, -5, 0.25}, {5, -1, 0.25}}),
              "degenerate: an edge meets an edge")
        << "on the rung";
    EXPECT_EQ(reasonFor({{-2, -2, 0.75}, {2, 2, 0.75}}, {{-2, -2, 0.25}, {2, 2, 0.25}}),
              "degenerate: an edge lies in a triangle");
}

// The blade goes back behind the front and crosses the plane of its walls.
TEST(Intersections, TheBladeMustNotMeetTheWallsThatItHasJustMade) {
    StepBench bench(icosphere(2), 0.2);
    bench.begin({{-1, 0.7, 0.01}, {1, 0.7, 0.013}});
    bench.cutTo({{-1, 0.02, 0.01}, {1, 0.02, 0.013}});
    const StepInput in = bench.stepTo({{-1, 0.2, 0.3}, {1, 0.2, -0.3}});
    EXPECT_EQ(reasonOf([&] { meet(in); }), "the blade meets the walls that it has just made");
}

void expectOnEdges(const StepInput& in, const Strip& strip, const CutCurves& curves) {
    for (const auto& [edge, hits] : curves.onEdge) {
        double last = 0;
        for (const EdgeHit& hit : hits) {
            const CutNode& node = curves.nodes[hit.node];
            EXPECT_EQ(node.kind, NodeKind::edge);
            EXPECT_EQ(edgeOf(node.a, node.b), edge);
            EXPECT_EQ(node.a, curves.nodes[hits.front().node].a) << "all from one end";
            EXPECT_TRUE(node.t > last && node.t < 1) << node.t << " after " << last;
            last = node.t;
            const auto mixed = [&](const Vec3& a, const Vec3& b) {
                return Vec3(a + node.t * (b - a));
            };
            const SurfaceMesh& mesh = in.mesh;
            EXPECT_EQ(node.position, mixed(mesh.position(node.a), mesh.position(node.b)));
            EXPECT_EQ(node.rest, mixed(mesh.restPosition(node.a), mesh.restPosition(node.b)));
            EXPECT_EQ(node.velocity, mixed(mesh.velocity(node.a), mesh.velocity(node.b)));
            const std::array<Vec3, 3> at = stripCorners(strip, hit.stripTriangle);
            const Vec3 normal = unitNormal(at[0], at[1], at[2]);
            EXPECT_LT(std::fabs(normal.dot(node.position - at[0])), kNear);
        }
    }
}

void expectOnFaces(const StepInput& in, const Strip& strip, const CutCurves& curves) {
    for (const auto& [key, id] : curves.onFace) {
        const CutNode& node = curves.nodes[id];
        EXPECT_EQ(node.kind, NodeKind::face);
        EXPECT_EQ(std::pair(node.a, node.stripEdge), key);
        EXPECT_GT(node.weights.minCoeff(), 0);
        EXPECT_NEAR(node.weights.sum(), 1, 1e-14);
        const Triangle& c = in.mesh.triangle(node.a);
        const auto mixed = [&](const auto& of) {
            return Vec3(node.weights[0] * of(c[0]) + node.weights[1] * of(c[1]) +
                        node.weights[2] * of(c[2]));
        };
        EXPECT_LT((node.position - mixed([&](int v) { return in.mesh.position(v); })).norm(),
                  1e-14);
        EXPECT_LT((node.rest - mixed([&](int v) { return in.mesh.restPosition(v); })).norm(),
                  1e-14);
        EXPECT_LT((node.velocity - mixed([&](int v) { return in.mesh.velocity(v); })).norm(),
                  1e-13);
        const StripNode& a = strip.nodes[strip.edges[key.second].a];
        const StripNode& b = strip.nodes[strip.edges[key.second].b];
        EXPECT_LT((node.position - a.position - node.u * (b.position - a.position)).norm(), kNear);
    }
}

/// The place in the layout plane is the same point of the strip.
void expectLaidOut(const Strip& strip, const CutCurves& curves) {
    for (const CutNode& node : curves.nodes) {
        const std::optional<Vec3> place = placeInStrip(strip, node.layout);
        ASSERT_TRUE(place.has_value());
        EXPECT_LT((*place - node.position).norm(), kNear);
    }
}

bool liesIn(const SurfaceMesh& mesh, const CutNode& node, int t) {
    return node.kind == NodeKind::face
               ? node.a == t
               : triangleHas(mesh, t, node.a) &&
                     (node.kind == NodeKind::vertex || triangleHas(mesh, t, node.b));
}

// With the inside on its left: along n_strip x n_mesh.
void expectSegments(const StepInput& in, const Strip& strip, const CutCurves& curves) {
    std::map<int, std::vector<int>> byTriangle;
    for (int i = 0; i < sizeOf(curves.segments); ++i) {
        const Segment& segment = curves.segments[i];
        byTriangle[segment.triangle].push_back(i);
        const CutNode& from = curves.nodes[segment.from];
        const CutNode& to = curves.nodes[segment.to];
        EXPECT_TRUE(liesIn(in.mesh, from, segment.triangle));
        EXPECT_TRUE(liesIn(in.mesh, to, segment.triangle));
        const std::array<Vec3, 3> at = stripCorners(strip, segment.stripTriangle);
        const Vec3 way =
            areaNormal(at[0], at[1], at[2]).cross(areaNormal(cornersOf(in.mesh, segment.triangle)));
        const Vec3 run = to.position - from.position;
        EXPECT_TRUE(run.norm() < kNear || way.dot(run) > 0) << "the body lies on the wrong side";
    }
    EXPECT_EQ(byTriangle, curves.segmentsOfTriangle);
}

/// A curve goes on at every node, but for the border of the strip and the ends of the front.
void expectCurvesGoOn(const Strip& strip, const CutCurves& curves) {
    std::vector<std::array<int, 2>> ends(curves.nodes.size(), {0, 0});
    for (const Segment& segment : curves.segments) {
        ++ends[segment.from][0];
        ++ends[segment.to][1];
    }
    for (int i = 0; i < sizeOf(curves.nodes); ++i) {
        const CutNode& node = curves.nodes[i];
        const bool onBorder = node.kind == NodeKind::vertex ||
                              (node.kind == NodeKind::face && strip.edges[node.stripEdge].onBorder);
        const auto [out, in] = ends[i];
        EXPECT_TRUE(onBorder ? out + in >= 1 : out == 1 && in == 1) << "node " << i;
    }
}

bool isHit(const CutCurves& curves, int u, int v, int s) {
    const auto hits = curves.onEdge.find(edgeOf(u, v));
    return hits != curves.onEdge.end() &&
           std::ranges::count(hits->second, s, &EdgeHit::stripTriangle) > 0;
}

/// What the exact test of one segment and one triangle finds for each pair.
void expectComplete(const StepInput& in, const Strip& strip, const CutCurves& curves) {
    for (const int t : livingTriangles(in.mesh)) {
        const std::array<Vec3, 3> at = cornersOf(in.mesh, t);
        for (int s = 0; s < sizeOf(strip.triangles); ++s) {
            for (int e = 0; e < 3; ++e) {
                const int u = in.mesh.triangle(t)[e];
                const int v = in.mesh.triangle(t)[(e + 1) % 3];
                EXPECT_EQ(isHit(curves, u, v, s),
                          pierces(at[e], at[(e + 1) % 3], stripCorners(strip, s)));
            }
        }
        for (int e = 0; e < sizeOf(strip.edges); ++e) {
            const StripEdge& edge = strip.edges[e];
            EXPECT_EQ(curves.onFace.count({t, e}) > 0,
                      edge.frontOf < 0 &&
                          pierces(strip.nodes[edge.a].position, strip.nodes[edge.b].position, at));
        }
    }
}

/// On both walls of an older slit, to the last bit.
template <class Key>
void expectSame(std::map<Key, Vec3>& known, const Key& key, const Vec3& place, int& pairs) {
    const auto [at, isNew] = known.emplace(key, place);
    EXPECT_EQ(at->second, place);
    pairs += isNew ? 0 : 1;
}

int expectCopiesMeetAlike(const SurfaceMesh& mesh, const CutCurves& curves) {
    int pairs = 0;
    std::map<std::array<int, 3>, Vec3> onEdge;
    for (const auto& [edge, hits] : curves.onEdge) {
        const Edge points = edgeOf(mesh.firstCopy(edge.first), mesh.firstCopy(edge.second));
        for (const EdgeHit& hit : hits) {
            expectSame(onEdge, {points.first, points.second, hit.stripTriangle},
                       curves.nodes[hit.node].position, pairs);
        }
    }
    std::map<std::array<int, 4>, Vec3> onFace;
    for (const auto& [key, id] : curves.onFace) {
        Triangle points = mesh.triangle(key.first);
        std::ranges::transform(points, points.begin(), [&](int v) { return mesh.firstCopy(v); });
        std::ranges::sort(points);
        expectSame(onFace, {points[0], points[1], points[2], key.second}, curves.nodes[id].position,
                   pairs);
    }
    return pairs;
}

TEST(Intersections, OfRandomStepsAreAllThatStripAndSurfaceShare) {
    const std::uint32_t seed = fuzzSeed(31);
    SCOPED_TRACE("seed " + std::to_string(seed));
    int pairs = 0;
    const int steps = forRandomSteps(seed, 60, [&](const StepInput& in, const PlannedStep&) {
        const auto [strip, curves] = meet(in);
        expectOnEdges(in, strip, curves);
        expectOnFaces(in, strip, curves);
        expectLaidOut(strip, curves);
        expectSegments(in, strip, curves);
        expectCurvesGoOn(strip, curves);
        expectComplete(in, strip, curves);
        pairs += expectCopiesMeetAlike(in.mesh, curves);
    });
    EXPECT_GT(steps, 100);
    EXPECT_GT(pairs, 30) << "of copies";
}

TEST(Intersections, TheFrontsEndsAreNodesOfTheirVertices) {
    StepBench bench(box(), 0.25);
    bench.begin(bladeAt(1, 0.1));
    bench.cutTo(bladeAt(-0.2, 0.1));
    const CutCurves curves = meet(bench.stepTo(bladeAt(-0.3, 0.1))).curves;
    const std::vector<RungNode>& rung = bench.rung();
    for (const RungNode& end : {rung[1], rung[rung.size() - 2]}) {
        const int id = curves.nodeOfVertex.find(end.vertex);
        ASSERT_GE(id, 0);
        EXPECT_EQ(curves.nodes[id].kind, NodeKind::vertex);
        EXPECT_EQ(curves.nodes[id].position, end.position);
    }
    EXPECT_EQ(curves.nodeOfVertex.size(), 2U);
}

}  // namespace
}  // namespace kerf::cut

#include "sim/cut/plan/subdivide.h"

namespace kerf::cut {
namespace {

using Directed = std::set<std::pair<int, int>>;

constexpr double kClose = 1e-4;

Vec3 placeOf(const SurfaceMesh& mesh, const CutCurves& curves, int corner) {
    return corner < mesh.vertexCount() ? mesh.position(corner)
                                       : curves.nodes[corner - mesh.vertexCount()].position;
}

Vec3 normalOf(const SurfaceMesh& mesh, const CutCurves& curves, const Triangle& t) {
    return areaNormal(placeOf(mesh, curves, t[0]), placeOf(mesh, curves, t[1]),
                      placeOf(mesh, curves, t[2]));
}

std::vector<NewTriangle> partsOf(const Subdivision& result, int parent) {
    std::vector<NewTriangle> parts;
    for (int i = 0; i < sizeOf(result.triangles); ++i) {
        if (result.parents[i] == parent) {
            parts.push_back(result.triangles[i]);
        }
    }
    return parts;
}

Directed edgesOf(const std::vector<NewTriangle>& parts) {
    Directed edges;
    for (const NewTriangle& part : parts) {
        for (int e = 0; e < 3; ++e) {
            const auto [at, isNew] = edges.insert({part.corners[e], part.corners[(e + 1) % 3]});
            EXPECT_TRUE(isNew) << "two parts run along one edge the same way";
        }
    }
    return edges;
}

/// The corners from u to v, with the nodes between.
std::vector<int> chainAlong(const SurfaceMesh& mesh, const CutCurves& curves, int u, int v) {
    std::vector<int> chain{u};
    if (const auto hits = curves.onEdge.find(edgeOf(u, v)); hits != curves.onEdge.end()) {
        for (const EdgeHit& hit : hits->second) {
            chain.push_back(cornerId(mesh, curves, hit.node));
        }
        const CutNode& first = curves.nodes[hits->second.front().node];
        std::reverse(chain.begin() + (first.a == u ? sizeOf(chain) : 1), chain.end());
    }
    chain.push_back(v);
    return chain;
}

/// The outer edges of what a triangle becomes: the same for both triangles at an edge.
Directed borderOf(const SurfaceMesh& mesh, const CutCurves& curves, int t) {
    Directed border;
    for (int h = 3 * t; h < 3 * t + 3; ++h) {
        const std::vector<int> chain = chainAlong(mesh, curves, mesh.origin(h), mesh.target(h));
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
            border.insert({chain[i], chain[i + 1]});
        }
    }
    return border;
}

/// Each edge inside has a part on both sides, each one on the border on one: nothing is left out.
void expectFits(const Directed& edges, const Directed& border) {
    Directed lonely;
    for (const auto& [from, to] : edges) {
        if (edges.count({to, from}) == 0) {
            lonely.insert({from, to});
        }
    }
    EXPECT_EQ(lonely, border);
}

void expectSameFace(const SurfaceMesh& mesh, const CutCurves& curves, int parent,
                    const std::vector<NewTriangle>& parts) {
    const Vec3 whole = normalOf(mesh, curves, mesh.triangle(parent));
    Vec3 sum = Vec3::Zero();
    for (const NewTriangle& part : parts) {
        const Vec3 normal = normalOf(mesh, curves, part.corners);
        EXPECT_GT(normal.dot(whole), -1e-12 * whole.squaredNorm()) << "it is turned over";
        EXPECT_EQ(part.side, CutSide::surface);
        EXPECT_EQ(part.kind, mesh.kind(parent));
        EXPECT_EQ(part.wallLabel, mesh.wallLabel(parent));
        sum += normal;
    }
    EXPECT_LT((sum - whole).norm(), 1e-9 * whole.norm()) << "the area changed";
}

int edgeNodesOf(const SurfaceMesh& mesh, const CutCurves& curves, int t) {
    return sizeOf(borderOf(mesh, curves, t)) - 3;
}

int faceNodesOf(const CutCurves& curves, int t) {
    return static_cast<int>(
        std::ranges::count_if(curves.onFace, [&](auto& entry) { return entry.first.first == t; }));
}

/// All that every division promises.
void expectDivided(const SurfaceMesh& mesh, const CutCurves& curves, const Subdivision& result) {
    int patterns = 0;
    for (const int count : result.patterns) {
        patterns += count;
    }
    EXPECT_EQ(patterns, sizeOf(result.replaced));
    std::vector<int> wanted;
    for (const auto& [t, segments] : curves.segmentsOfTriangle) {
        wanted.push_back(t);
        const std::vector<NewTriangle> parts = partsOf(result, t);
        EXPECT_EQ(sizeOf(parts), 1 + edgeNodesOf(mesh, curves, t) + 2 * faceNodesOf(curves, t));
        const Directed edges = edgesOf(parts);
        expectFits(edges, borderOf(mesh, curves, t));
        expectSameFace(mesh, curves, t, parts);
        for (const int i : segments) {
            const int from = cornerId(mesh, curves, curves.segments[i].from);
            const int to = cornerId(mesh, curves, curves.segments[i].to);
            EXPECT_TRUE(edges.count({from, to}) > 0 && edges.count({to, from}) > 0);
        }
    }
    EXPECT_EQ(result.replaced, wanted);
}

// Of the unit tetrahedron: the face with corners 1, 2 and 3.
constexpr int kFace = 3;
const Vec3 kMiddle = Vec3::Constant(1.0 / 3);

/// What a drawing on the face makes of it.
void expectPattern(const DrawnCurves& drawn, const SurfaceMesh& mesh, SubdivisionPattern pattern,
                   int parts) {
    const Subdivision result = subdivide(mesh, drawn.curves, kClose);
    expectDivided(mesh, drawn.curves, result);
    EXPECT_EQ(sizeOf(partsOf(result, kFace)), parts) << nameOf(pattern);
    EXPECT_EQ(result.patterns[static_cast<int>(pattern)], 1) << nameOf(pattern);
}

class SubdivideAFace : public ::testing::Test {
  protected:
    SurfaceMesh mesh = unitTetrahedron();
    DrawnCurves drawn{mesh};
};

TEST_F(SubdivideAFace, FromAnEdgeToTheInsideGivesFour) {
    drawn.segment(kFace, drawn.onEdge(1, 2, 0.4, 0), drawn.inFace(kFace, kMiddle, 1), 0);
    expectPattern(drawn, mesh, SubdivisionPattern::oneToFour, 4);
}

TEST_F(SubdivideAFace, FromEdgeToEdgeGivesThree) {
    drawn.segment(kFace, drawn.onEdge(1, 2, 0.4, 0), drawn.onEdge(2, 3, 0.5, 0), 0);
    expectPattern(drawn, mesh, SubdivisionPattern::oneToThreeA, 3);
}

TEST_F(SubdivideAFace, FromAVertexToTheOtherEdgeGivesTwo) {
    drawn.segment(kFace, drawn.atVertex(3), drawn.onEdge(1, 2, 0.4, 0), 0);
    expectPattern(drawn, mesh, SubdivisionPattern::oneToTwo, 2);
}

TEST_F(SubdivideAFace, FromAVertexToTheInsideGivesThree) {
    drawn.segment(kFace, drawn.atVertex(3), drawn.inFace(kFace, kMiddle, 0), 0);
    expectPattern(drawn, mesh, SubdivisionPattern::oneToThreeB, 3);
}

TEST_F(SubdivideAFace, ACurveThatStartsAndEndsInsideHasTwoKinks) {
    drawn.segment(kFace, drawn.inFace(kFace, {0.2, 0.2, 0.6}, 0), drawn.inFace(kFace, kMiddle, 1),
                  0);
    expectPattern(drawn, mesh, SubdivisionPattern::twoKinks, 5);
}

TEST_F(SubdivideAFace, ACurveThatBendsInsideHasTwoSegments) {
    const int kink = drawn.inFace(kFace, kMiddle, 0);
    drawn.segment(kFace, drawn.onEdge(1, 2, 0.4, 0), kink, 0);
    drawn.segment(kFace, kink, drawn.onEdge(2, 3, 0.4, 1), 1);
    expectPattern(drawn, mesh, SubdivisionPattern::twoSegments, 5);
}

TEST_F(SubdivideAFace, PartsRunAroundAsTheFaceDoes) {
    const int node = drawn.onEdge(1, 2, 0.4, 0);
    drawn.segment(kFace, drawn.atVertex(3), node, 0);
    const int corner = mesh.vertexCount() + node;
    const Directed edges = edgesOf(partsOf(subdivide(mesh, drawn.curves, kClose), kFace));
    EXPECT_EQ(edges,
              (Directed{{1, corner}, {corner, 3}, {3, 1}, {corner, 2}, {2, 3}, {3, corner}}));
}

TEST_F(SubdivideAFace, ATriangleBesideACurveIsDividedAtItsNodesAlone) {
    drawn.segment(kFace, drawn.onEdge(1, 2, 0.3, 0), drawn.onEdge(1, 2, 0.6, 1), 0);
    const Subdivision result = subdivide(mesh, drawn.curves, kClose);
    EXPECT_EQ(result.replaced, (std::vector<int>{0, kFace}));
    EXPECT_EQ(sizeOf(partsOf(result, 0)), 3);
}

TEST_F(SubdivideAFace, WithoutCurvesThereIsNothingToDivide) {
    const Subdivision result = subdivide(mesh, drawn.curves, kClose);
    EXPECT_TRUE(result.triangles.empty());
    EXPECT_TRUE(result.replaced.empty());
}

/// At another of the corners of kFace.
SurfaceMesh tetrahedronWhoseFaceBegins(int corner) {
    const SurfaceMesh mesh = unitTetrahedron();
    std::vector<Vec3> positions;
    positions.reserve(mesh.vertexCount());
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        positions.push_back(mesh.position(v));
    }
    std::vector<Triangle> triangles;
    triangles.reserve(mesh.triangleSlots());
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        triangles.push_back(mesh.triangle(t));
    }
    std::rotate(triangles[kFace].begin(), triangles[kFace].begin() + corner,
                triangles[kFace].end());
    return SurfaceMesh::fromTriangles(positions, triangles);
}

// A curve parallel to a side of an equilateral face leaves four points on one circle: which of two
// diagonals they get is a matter of order, which both walls of a slit must have in common.
TEST(Subdivide, WhereAFaceBeginsDecidesNothing) {
    const Triangle corners{1, 2, 3};
    for (int apex = 0; apex < 3; ++apex) {
        std::set<Directed> found;
        for (int first = 0; first < 3; ++first) {
            const SurfaceMesh mesh = tetrahedronWhoseFaceBegins(first);
            DrawnCurves drawn(mesh);
            const int u = corners[apex];
            drawn.segment(kFace, drawn.onEdge(u, corners[(apex + 1) % 3], 0.5, 0),
                          drawn.onEdge(u, corners[(apex + 2) % 3], 0.5, 0), 0);
            found.insert(edgesOf(partsOf(subdivide(mesh, drawn.curves, kClose), kFace)));
        }
        EXPECT_EQ(found.size(), 1U) << "apex " << corners[apex];
    }
}

class SubdivideRefuses : public SubdivideAFace {
  protected:
    std::string reason() const {
        return reasonOf([&] { subdivide(mesh, drawn.curves, kClose); });
    }
};

TEST_F(SubdivideRefuses, ACurveThatStopsAtAnEdge) {
    drawn.segment(kFace, drawn.onEdge(1, 2, 0.3, 0), drawn.onEdge(2, 3, 0.5, 0), 0);
    drawn.curves.segmentsOfTriangle.erase(0);
    EXPECT_EQ(reason(), "the curve stops at an edge");
}

TEST_F(SubdivideRefuses, ACurveThatStopsInATriangle) {
    drawn.inFace(kFace, kMiddle, 0);
    drawn.curves.segmentsOfTriangle.erase(kFace);
    EXPECT_EQ(reason(), "the curve stops in a triangle");
}

TEST_F(SubdivideRefuses, TwoNodesAtOnePlace) {
    drawn.segment(kFace, drawn.inFace(kFace, kMiddle, 0), drawn.inFace(kFace, kMiddle, 1), 0);
    EXPECT_EQ(reason(), "two curve nodes coincide in a triangle");
}

TEST_F(SubdivideRefuses, ACurveToANodeOfAnotherTriangle) {
    drawn.segment(kFace, drawn.atVertex(0), drawn.inFace(kFace, kMiddle, 0), 0);
    EXPECT_EQ(reason(), "a curve ends outside its triangle");
}

TEST_F(SubdivideRefuses, CurvesThatCross) {
    drawn.segment(kFace, drawn.onEdge(1, 2, 0.5, 0), drawn.atVertex(3), 0);
    drawn.segment(kFace, drawn.onEdge(2, 3, 0.5, 1), drawn.atVertex(1), 1);
    EXPECT_EQ(reason(), "curves cross in a triangle");
}

/// Draws at random without crossings.
class RandomDrawing {
  public:
    RandomDrawing(const SurfaceMesh& mesh, std::mt19937& random)
        : mesh_(mesh), random_(random), drawn_(mesh) {}

    CutCurves run() {
        std::set<int> triangles;
        for (int i = 0; i < 6; ++i) {
            triangles.insert(below(mesh_.triangleSlots()));
        }
        for (const int t : triangles) {
            addPoints(t);
        }
        for (const int t : triangles) {
            addSegments(t);
        }
        return std::move(drawn_.curves);
    }

  private:
    struct Point {
        int node;
        Vec3 weights;
    };

    int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }

    void addPoints(int t) {
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            for (int i = below(3); i > 0; --i) {
                drawn_.onEdge(mesh_.origin(h), mesh_.target(h), uniform(0.01, 0.99), number_++);
            }
        }
        for (int i = below(4); i > 0; --i) {
            const Vec3 weights(uniform(0.01, 1), uniform(0.01, 1), uniform(0.01, 1));
            drawn_.inFace(t, weights / weights.sum(), number_++);
        }
        drawn_.curves.segmentsOfTriangle[t];
    }

    std::vector<Point> pointsOf(int t) {
        const Triangle& c = mesh_.triangle(t);
        std::vector<Point> points;
        for (int i = 0; i < 3; ++i) {
            points.push_back({drawn_.atVertex(c[i]), Vec3::Unit(i)});
            for (const EdgeHit& hit : drawn_.curves.onEdge[edgeOf(c[i], c[(i + 1) % 3])]) {
                const CutNode& node = drawn_.curves.nodes[hit.node];
                const double part = node.a == c[i] ? node.t : 1 - node.t;
                points.push_back(
                    {hit.node, (1 - part) * Vec3::Unit(i) + part * Vec3::Unit((i + 1) % 3)});
            }
        }
        for (const auto& [place, node] : drawn_.curves.onFace) {
            if (place.first == t) {
                points.push_back({node, drawn_.curves.nodes[node].weights});
            }
        }
        std::erase_if(drawn_.curves.onEdge, [](const auto& entry) { return entry.second.empty(); });
        return points;
    }

    static double side(const Vec3& p, const Vec3& q, const Vec3& r) {
        return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
    }

    static bool areApart(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
        constexpr double kClear = 1e-6;
        const double ofR = side(p, q, r), ofS = side(p, q, s);
        const double ofP = side(r, s, p), ofQ = side(r, s, q);
        return std::min(ofR, ofS) > kClear || std::max(ofR, ofS) < -kClear ||
               std::min(ofP, ofQ) > kClear || std::max(ofP, ofQ) < -kClear;
    }

    /// Nothing but its ends lies on the way, nor do other segments cross it.
    static bool isFree(const Point& p, const Point& q, const std::vector<Point>& points,
                       const std::vector<std::pair<Point, Point>>& known) {
        const auto isEnd = [&](const Point& r) { return r.node == p.node || r.node == q.node; };
        if (p.weights.cwiseMax(q.weights).minCoeff() == 0) {
            return false;  // both lie on one edge
        }
        return std::ranges::all_of(
                   points,
                   [&](const Point& r) {
                       return isEnd(r) || std::fabs(side(p.weights, q.weights, r.weights)) > 1e-6;
                   }) &&
               std::ranges::all_of(known, [&](const auto& s) {
                   return isEnd(s.first) || isEnd(s.second) ||
                          areApart(p.weights, q.weights, s.first.weights, s.second.weights);
               });
    }

    void addSegments(int t) {
        const std::vector<Point> points = pointsOf(t);
        std::vector<std::pair<Point, Point>> known;
        for (int i = 0; i < 6; ++i) {
            const Point& p = points[below(sizeOf(points))];
            const Point& q = points[below(sizeOf(points))];
            if (p.node != q.node && isFree(p, q, points, known)) {
                known.emplace_back(p, q);
                drawn_.segment(t, p.node, q.node, number_++);
            }
        }
    }

    const SurfaceMesh& mesh_;
    std::mt19937& random_;
    DrawnCurves drawn_;
    int number_ = 0;
};

TEST(Subdivide, AnyDrawingDividesItsTrianglesWithoutGaps) {
    const std::uint32_t seed = fuzzSeed(21);
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random{seed};
    const SurfaceMesh mesh = icosphere(1);
    int segments = 0;
    for (int i = 0; i < 400; ++i) {
        const CutCurves curves = RandomDrawing(mesh, random).run();
        expectDivided(mesh, curves, subdivide(mesh, curves, kClose));
        segments += sizeOf(curves.segments);
    }
    EXPECT_GT(segments, 3000);
}

TEST(Subdivide, CurvesOfTheBladeDivideWhatTheyCross) {
    const std::uint32_t seed = fuzzSeed(22);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const int steps = forRandomSteps(seed, 40, [](const StepInput& in, const PlannedStep& s) {
        expectDivided(in.mesh, s.plan.curves,
                      subdivide(in.mesh, s.plan.curves, kCloseNoise * in.h));
    });
    EXPECT_GT(steps, 60);
}

/// Parts by what their corners have in common with those of the mirror; each starts at its lowest.
std::set<Triangle> pointsOf(const SurfaceMesh& mesh, const std::vector<NewTriangle>& parts,
                            bool turned) {
    std::set<Triangle> result;
    for (const NewTriangle& part : parts) {
        Triangle points{};
        std::ranges::transform(part.corners, points.begin(), [&](int corner) {
            const int node = corner - mesh.vertexCount();
            return node < 0 ? mesh.firstCopy(corner) : mesh.vertexCount() + node / 2;
        });
        if (turned) {
            std::swap(points[1], points[2]);
        }
        std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
        result.insert(points);
    }
    return result;
}

TEST(Subdivide, BothWallsOfASlitAreDividedAlike) {
    const SurfaceMesh mesh = halvedBox(1e-2 * kClose);
    const std::vector<int> walls = wallsOfPlus(mesh);
    EXPECT_GT(walls.size(), 10U);
    for (const int t : walls) {
        const int mirror = test::mirrorOf(mesh, t);
        ASSERT_GE(mirror, 0);
        const Subdivision result = subdivide(mesh, drawnOnBoth(mesh, t, mirror).curves, kClose);
        EXPECT_EQ(pointsOf(mesh, partsOf(result, t), false),
                  pointsOf(mesh, partsOf(result, mirror), true));
    }
}

}  // namespace
}  // namespace kerf::cut

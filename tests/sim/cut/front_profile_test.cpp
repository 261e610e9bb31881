#include "sim/cut/plan/strip/front_profile.h"

#include "sim/cut/plan/input/slit_opening.h"
#include "sim/cut/surface/stroke_surface.h"

namespace kerf::cut {
namespace {

const Blade kBlade{{0, 1, 0}, {1, 1, 0}};

/// From a front of such heights between x = 0 and x = 1 to the blade; vertex i is node i.
Strip stripOver(const std::vector<double>& heights) {
    Strip strip;
    const int last = sizeOf(heights) - 1;
    std::vector<int> lower;
    std::vector<double> lowerS;
    for (int i = 0; i <= last; ++i) {
        StripNode& node = strip.nodes.emplace_back();
        node.s = i / static_cast<double>(last);
        node.position = {node.s, heights[i], 0};
        node.vertices = {i};
        lower.push_back(i);
        lowerS.push_back(node.s);
    }
    strip.oldCount = last + 1;
    for (const double s : {0.0, 0.3, 0.6, 1.0}) {
        strip.newRung.push_back(sizeOf(strip.nodes));
        StripNode& node = strip.nodes.emplace_back();
        node.s = s;
        node.position = {s, 1, 0};
    }
    strip.triangles = stitch(lower, lowerS, strip.newRung, {0.0, 0.3, 0.6, 1.0});
    for (const Triangle& t : strip.triangles) {
        for (int e = 0; e < 3; ++e) {
            strip.edges.push_back({t[e], t[(e + 1) % 3]});
        }
    }
    return strip;
}

double cross(const Vec3& p, const Vec3& q, const Vec3& r) {
    return (q - p).cross(r - p).z();
}

bool isInside(const Strip& strip, const Triangle& t, const Vec3& p) {
    for (int e = 0; e < 3; ++e) {
        if (cross(strip.nodes[t[e]].position, strip.nodes[t[(e + 1) % 3]].position, p) <= 0) {
            return false;
        }
    }
    return true;
}

TEST(FrontProfile, TellsWallsBehindAStraightFront) {
    const Strip strip = stripOver({0, 0, 0, 0, 0});
    const FrontProfile front(kBlade, strip);
    const auto at = [&](int node) { return strip.nodes[node].position; };
    const Vec3 behind(0.4, -0.2, 0);
    const Vec3 fartherBehind(0.3, -0.3, 0.1);
    EXPECT_TRUE(front.isBehind({1, 2, 9}, {at(1), at(2), behind})) << "with an edge of the front";
    EXPECT_TRUE(front.isBehind({2, 8, 9}, {at(2), fartherBehind, behind})) << "with a vertex";
    EXPECT_TRUE(front.isBehind({7, 8, 9}, {fartherBehind, behind, {0.6, -0.1, 0}}));
    EXPECT_FALSE(front.isBehind({1, 3, 9}, {at(1), at(3), behind})) << "over node 2";
    EXPECT_FALSE(front.isBehind({1, 7, 9}, {at(1), at(2), behind})) << "a copy of vertex 2";
    EXPECT_FALSE(front.isBehind({2, 8, 9}, {at(2), behind, {0.6, 0.1, 0}})) << "ahead";
    EXPECT_FALSE(front.isBehind({2, 8, 9}, {at(2), behind, {-0.1, -0.1, 0}})) << "beside";
}

TEST(FrontProfile, NothingIsBehindAFrontThatRunsBack) {
    Strip strip = stripOver({0, 0, 0, 0, 0});
    strip.nodes[2].position.x() = 0.2;
    const FrontProfile front(kBlade, strip);
    EXPECT_FALSE(front.isBehind({7, 8, 9}, {Vec3(0.4, -0.2, 0), {0.3, -0.3, 0}, {0.5, -0.3, 0}}));
}

// Along fronts as jagged as no stroke makes them.
TEST(FrontProfile, WhatIsBehindLiesInNoTriangleOfTheStrip) {
    constexpr unsigned kProfileSeed = 11;
    SCOPED_TRACE("seed " + std::to_string(kProfileSeed));
    std::mt19937 random{kProfileSeed};
    std::uniform_real_distribution<double> uniform{0, 1};
    int behind = 0;
    for (int i = 0; i < 4000; ++i) {
        std::vector<double> heights(6);
        for (double& height : heights) {
            height = 0.5 * uniform(random);
        }
        const Strip strip = stripOver(heights);
        const FrontProfile front(kBlade, strip);
        Triangle ids{};
        std::array<Vec3, 3> corners;
        for (int k = 0; k < 3; ++k) {
            const bool isNode = uniform(random) < 0.4;
            ids[k] = isNode ? static_cast<int>(6 * uniform(random)) : 100 + k;
            corners[k] = isNode ? strip.nodes[ids[k]].position
                                : Vec3(uniform(random), 0.6 * uniform(random) - 0.3, 0);
        }
        const bool hasArea = ids[0] != ids[1] && ids[1] != ids[2] && ids[2] != ids[0];
        if (!hasArea || !front.isBehind(ids, corners)) {
            continue;
        }
        ++behind;
        for (int k = 0; k < 50; ++k) {
            const double a = uniform(random);
            const double b = uniform(random) * (1 - a);
            const Vec3 p = a * corners[0] + b * corners[1] + (1 - a - b) * corners[2];
            for (const Triangle& t : strip.triangles) {
                EXPECT_FALSE(isInside(strip, t, p)) << "front " << i;
            }
        }
    }
    EXPECT_GT(behind, 300);
}

double edgeOf(const SurfaceMesh& mesh) {
    return (mesh.position(mesh.target(0)) - mesh.position(mesh.origin(0))).norm();
}

std::size_t samplesAtPole(int subdivisions) {
    const SurfaceMesh mesh = icosphere(subdivisions);
    return cut::StrokeSurface(mesh).samplesAround({Vec3::UnitY()}, edgeOf(mesh)).size();
}

TEST(StrokeSurface, NeedsFewMoreSamplesOfALargeBody) {
    const std::size_t small = samplesAtPole(3);
    EXPECT_GT(small, 40u);
    EXPECT_LT(samplesAtPole(6), 2 * small);
}

TEST(StrokeSurface, SamplesAllThatIsNearAndStandsForTheWhole) {
    const SurfaceMesh mesh = icosphere(5);
    const double edge = edgeOf(mesh);
    const std::vector<Vec3> places{Vec3::UnitX(), -Vec3::UnitZ()};
    const auto samples = cut::StrokeSurface(mesh).samplesAround(places, edge);
    double weights = 0;
    for (const cut::SurfaceSample& sample : samples) {
        weights += sample.weight;
    }
    EXPECT_NEAR(weights, mesh.aliveTriangles(), 1e-6);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const bool near = std::ranges::any_of(
            places, [&](const Vec3& p) { return (mesh.position(v) - p).norm() < edge; });
        const bool sampled = std::ranges::any_of(
            samples, [&](const cut::SurfaceSample& sample) { return sample.vertex == v; });
        EXPECT_TRUE(sampled || !near) << v;
    }
}

TEST(StrokeSurface, FollowsCutsLikeOneThatIsMadeAnew) {
    SurfaceMesh mesh = icosphere(3);
    cut::StrokeSurface followed(mesh);
    constexpr double kMostRestMotion = 0.1;
    Cutter cutter(mesh, exactSettings());
    const Stroke stroke =
        straightStroke({0.013, 0.021, 0.3}, Vec3::UnitX(), -Vec3::UnitY(), 3, 2, 9);
    eachStep(cutter, stroke, [&](const CutResult& result) {
        followed.follow(changedTriangles(result.delta), kMostRestMotion);
    });
    followed.beginStroke();
    const cut::StrokeSurface fresh(mesh);
    EXPECT_EQ(followed.vertexCount(), fresh.vertexCount());
    int found = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3 rest = 0.9 * mesh.restPosition(v);
        const auto a = followed.insidePosition(rest, mesh.position(v), 0.2);
        const auto b = fresh.insidePosition(rest, mesh.position(v), 0.2);
        EXPECT_EQ(a, b) << v;
        found += a.has_value();
    }
    EXPECT_GT(found, 500);
}

constexpr double kH = 0.25;
constexpr double kOpen = 0.1 * kH;  // as far from the strip as walls are seen

/// A box in two halves, cut in the plane z = 0.1.
class SlitOpeningOfABox : public ::testing::Test {
  protected:
    SlitOpeningOfABox() {
        bench.begin(bladeAt(1, 0.1));
        bench.cutTo(bladeAt(-1, 0.1));
        bench.seesSlitsOpen = true;
    }
    SlitOpening openedBy(const Blade& from, const Blade& to) {
        bench.begin(from);
        return bench.stepTo(to).opening;
    }

    StepBench bench{box(Vec3::Ones(), 2), kH};
};

TEST_F(SlitOpeningOfABox, OpensEachWallIntoItsHalf) {
    const double beside = 0.004;
    const SlitOpening opening = openedBy(bladeAt(1, 0.1 + beside), bladeAt(-1, 0.1 + beside));
    const PieceMap pieces = findPieces(bench.mesh);
    for (const auto& [v, way] : opening.displacements()) {
        const bool isUpper = pieces.pieces[pieces.ofVertex[v]].volume < 0.5;
        EXPECT_NEAR(way.x(), 0, 1e-9);
        EXPECT_NEAR(way.y(), 0, 1e-9);
        EXPECT_NEAR(way.z(), isUpper ? kOpen + beside : beside - kOpen, 1e-9);
    }
}

TEST_F(SlitOpeningOfABox, OpensAllOfAWallThatTheBladeRunsAlong) {
    const SlitOpening opening = openedBy(bladeAt(1, 0.1), bladeAt(-1, 0.1));
    std::set<int> wanted;
    for (const int t : livingTriangles(bench.mesh)) {
        if (bench.mesh.kind(t) == SurfaceKind::wall) {
            wanted.insert(bench.mesh.triangle(t).begin(), bench.mesh.triangle(t).end());
        }
    }
    for (const int v : wanted) {
        EXPECT_FALSE(opening.displacement(v).isZero(0)) << v;
    }
    EXPECT_NEAR(opening.reach(), kOpen, 1e-9);
}

TEST_F(SlitOpeningOfABox, LeavesTheRestWhereItIs) {
    const SlitOpening opening = openedBy(bladeAt(1, 0.1), bladeAt(-1, 0.1));
    for (int v = 0; v < bench.mesh.vertexCount(); ++v) {
        const bool isFar = std::fabs(bench.mesh.position(v).z() - 0.1) > kOpen;
        EXPECT_TRUE(!isFar || opening.displacement(v).isZero(0)) << v;
        EXPECT_EQ(opening.displacements().count(v) == 0, opening.displacement(v).isZero(0));
    }
}

TEST_F(SlitOpeningOfABox, ABladeBesideOrAcrossItOpensNothing) {
    EXPECT_TRUE(openedBy(bladeAt(1, 0.13), bladeAt(-1, 0.13)).empty()) << "too far";
    EXPECT_TRUE(openedBy({{-2, 1, 0.25}, {2, 1, 0.25}}, {{-2, -1, -0.05}, {2, -1, -0.05}}).empty())
        << "8.5 degrees";
    EXPECT_TRUE(openedBy({{0.1, 1, -2}, {0.1, 1, 2}}, {{0.1, -1, -2}, {0.1, -1, 2}}).empty());
    EXPECT_EQ(openedBy(bladeAt(1, 0.3), bladeAt(-1, 0.3)).reach(), 0);
}

TEST(SlitOpeningOfItsOwnStroke, IsNone) {
    StepBench bench(box(), kH);
    bench.seesSlitsOpen = true;
    bench.begin(bladeAt(1, 0.1));
    bench.cutTo(bladeAt(-0.2, 0.1));
    EXPECT_TRUE(bench.stepTo(bladeAt(-0.4, 0.1)).opening.empty());
    bench.cutTo(bladeAt(-1, 0.1));
    EXPECT_TRUE(bench.stepTo(bladeAt(1, 0.1)).opening.empty()) << "back again";
}

}  // namespace
}  // namespace kerf::cut

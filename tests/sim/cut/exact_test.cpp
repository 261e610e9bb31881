#include "sim/base/predicates.h"
#include "sim/cut/cleanup/self_piercing.h"
#include "sim/cut/exact/directed_edges.h"
#include "sim/cut/surface/broad_phase.h"
#include "sim/mesh/triangle_tree.h"

namespace kerf::cut {
namespace {

__extension__ typedef __int128 Wide;

constexpr std::uint64_t kSeed = 20240601;
constexpr double kScale = 0x1p-31;

/// Integer coordinates: their determinants are exact in 128 bits, and so are the doubles.
struct Lattice {
    long long x, y, z;
    Vec3 scaled() const {
        return Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)) *
               kScale;
    }
    Vec2 flat() const { return Vec2(static_cast<double>(x), static_cast<double>(y)) * kScale; }
};

class LatticePoints {
  public:
    Lattice next(long long range) { return {number(range), number(range), number(range)}; }
    long long number(long long range) {
        return static_cast<long long>(engine_() % static_cast<std::uint64_t>(2 * range)) - range;
    }

  private:
    std::mt19937_64 engine_{kSeed};
};

int signOf(Wide value) {
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

int exactSign3d(const Lattice& a, const Lattice& b, const Lattice& c, const Lattice& p) {
    const Wide ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
    const Wide vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
    const Wide wx = p.x - a.x, wy = p.y - a.y, wz = p.z - a.z;
    return signOf((uy * vz - uz * vy) * wx + (uz * vx - ux * vz) * wy + (ux * vy - uy * vx) * wz);
}

int exactSign2d(const Lattice& a, const Lattice& b, const Lattice& c) {
    return signOf(Wide(b.x - a.x) * (c.y - a.y) - Wide(b.y - a.y) * (c.x - a.x));
}

TEST(Predicates, RandomTetrahedraHaveExactSigns) {
    LatticePoints points;
    for (int i = 0; i < 20000; ++i) {
        const Lattice a = points.next(1 << 30), b = points.next(1 << 30);
        const Lattice c = points.next(1 << 30), p = points.next(1 << 30);
        EXPECT_EQ(orient3d(a.scaled(), b.scaled(), c.scaled(), p.scaled()).sign,
                  exactSign3d(a, b, c, p));
        EXPECT_EQ(orientSign3d(a.scaled(), b.scaled(), c.scaled(), p.scaled()),
                  exactSign3d(a, b, c, p));
        EXPECT_EQ(orient2d(a.flat(), b.flat(), c.flat()), exactSign2d(a, b, c));
    }
}

TEST(Predicates, NearlyCoplanarPointsHaveExactSigns) {
    LatticePoints points;
    int zeros = 0;
    for (int i = 0; i < 20000; ++i) {
        const Lattice a = points.next(1 << 26), b = points.next(1 << 26), c = points.next(1 << 26);
        const long long j = points.number(8), k = points.number(8);
        // A lattice point of the plane abc, moved by at most one step of the lattice.
        const Lattice p{a.x + j * (b.x - a.x) + k * (c.x - a.x) + points.number(2),
                        a.y + j * (b.y - a.y) + k * (c.y - a.y),
                        a.z + j * (b.z - a.z) + k * (c.z - a.z)};
        const Orientation found = orient3d(a.scaled(), b.scaled(), c.scaled(), p.scaled());
        EXPECT_EQ(found.sign, exactSign3d(a, b, c, p));
        EXPECT_EQ(orientSign3d(a.scaled(), b.scaled(), c.scaled(), p.scaled()), found.sign);
        EXPECT_EQ(found.sign > 0, found.value > 0);
        EXPECT_EQ(found.sign < 0, found.value < 0);
        zeros += found.sign == 0;
    }
    EXPECT_GT(zeros, 1000);
}

TEST(Predicates, NearlyCollinearPointsHaveExactSigns) {
    LatticePoints points;
    int zeros = 0;
    for (int i = 0; i < 20000; ++i) {
        const Lattice a = points.next(1 << 26), b = points.next(1 << 26);
        const long long k = points.number(8);
        const Lattice c{a.x + k * (b.x - a.x) + points.number(2), a.y + k * (b.y - a.y), 0};
        EXPECT_EQ(orient2d(a.flat(), b.flat(), c.flat()), exactSign2d(a, b, c));
        zeros += exactSign2d(a, b, c) == 0;
    }
    EXPECT_GT(zeros, 1000);
}

TEST(Predicates, LexicographicOrderFallsBackToIds) {
    EXPECT_TRUE(comesBefore({0, 1, 2}, 5, {0, 1, 3}, 1));
    EXPECT_FALSE(comesBefore({0, 2, 2}, 1, {0, 1, 3}, 5));
    EXPECT_TRUE(comesBefore({0, 1, 2}, 1, {0, 1, 2}, 5));
    EXPECT_FALSE(comesBefore({0, 1, 2}, 5, {0, 1, 2}, 5));
}

constexpr std::array<std::array<double, 3>, 3> kCorners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};

std::array<Vec3, 3> triangle() {
    std::array<Vec3, 3> corners;
    std::ranges::transform(kCorners, corners.begin(),
                           [](const auto& c) { return Vec3(c[0], c[1], c[2]); });
    return corners;
}

TEST(Pierces, TheInsideAloneAndFromBothSides) {
    EXPECT_TRUE(pierces({0.2, 0.2, -1}, {0.3, 0.2, 1}, triangle()));
    EXPECT_TRUE(pierces({0.3, 0.2, 1}, {0.2, 0.2, -1}, triangle()));
    EXPECT_FALSE(pierces({0.2, 0.2, 0.1}, {0.3, 0.2, 1}, triangle())) << "ends before it";
    EXPECT_FALSE(pierces({2, 2, -1}, {2, 2, 1}, triangle())) << "passes beside it";
}

TEST(Pierces, NotWhereTheyOnlyTouch) {
    EXPECT_FALSE(pierces({0.2, 0.2, 0}, {0.2, 0.2, 1}, triangle())) << "begins in its plane";
    EXPECT_FALSE(pierces({0.5, 0, -1}, {0.5, 0, 1}, triangle())) << "through an edge";
    EXPECT_FALSE(pierces({0, 0, -1}, {0, 0, 1}, triangle())) << "through a corner";
    EXPECT_FALSE(pierces({-1, 0.2, 0}, {1, 0.2, 0}, triangle())) << "lies in its plane";
}

constexpr int kTop = 0;
const Vec3 kThroughTheBottom(0.9, -0.9, 0.1);

/// About the origin, with its top at this place.
SurfaceMesh octahedron(const Vec3& top) {
    TriangleSoup soup;
    soup.positions = {top, {1, 0, 0}, {0, 0, 1}, {-1, 0, 0}, {0, 0, -1}, {0, -1, 0}};
    for (int i = 0; i < 4; ++i) {
        const int a = 1 + i;
        const int b = 1 + (i + 1) % 4;
        soup.triangles.push_back({kTop, b, a});
        soup.triangles.push_back({5, a, b});
    }
    return meshOf(soup);
}

int piercedPairs(const SurfaceMesh& mesh) {
    int ends = 0;
    for (const int t : livingTriangles(mesh)) {
        for (const int other : piercedNeighbours(mesh, t)) {
            EXPECT_TRUE(std::ranges::binary_search(piercedNeighbours(mesh, other), t));
            ++ends;
        }
    }
    return ends / 2;
}

TEST(SelfPiercing, AMoveAddsPairsOrNot) {
    const Vec3 up(0, 1, 0);
    const auto moveAdds = [](const SurfaceMesh& mesh, const Vec3& place) {
        OneRing ring = ringOfMove(mesh, starOf(mesh, kTop), kTop);
        ring.position = place;
        return addsPiercings(mesh, std::vector<OneRing>{ring});
    };
    const SurfaceMesh sound = octahedron(up);
    const SurfaceMesh dented = octahedron(kThroughTheBottom);
    EXPECT_GT(piercedPairs(dented), 0);
    EXPECT_EQ(piercedPairs(sound), 0);
    EXPECT_FALSE(moveAdds(sound, 2 * up));
    EXPECT_TRUE(moveAdds(sound, kThroughTheBottom));
    EXPECT_FALSE(moveAdds(dented, up));
}

TEST(SelfPiercing, LyingFlatOnItselfCounts) {
    EXPECT_EQ(piercedPairs(octahedron({0, -0.4, 0})), 0) << "dented";
    EXPECT_EQ(piercedPairs(octahedron({0, 0, 0.5})), 0) << "with a flat top";
    EXPECT_GT(piercedPairs(octahedron({0.25, -0.5, 0.25})), 0) << "its top in a face of its bottom";
}

/// The same, with a bottom that a cut made.
SurfaceMesh cutOctahedron(const Vec3& top) {
    SurfaceMesh mesh = octahedron(top);
    for (int t = 0; t < 8; ++t) {
        const Triangle corners = mesh.triangle(t);
        if (std::ranges::find(corners, kTop) != corners.end()) {
            continue;
        }
        const int wall = mesh.addTriangle(corners, SurfaceKind::wall, 0);
        for (int k = 0; k < 3; ++k) {
            mesh.link(3 * wall + k, mesh.twin(3 * t + k));
            mesh.setOutgoing(corners[k], 3 * wall + k);
        }
        mesh.removeTriangle(t);
    }
    return mesh;
}

TEST(SelfPiercing, SkinThatTouchesAWallCounts) {
    const Vec3 inFace(0.25, -0.5, 0.25);
    EXPECT_EQ(piercedPairs(cutOctahedron({0, 1, 0})), 0);
    EXPECT_GT(piercedPairs(cutOctahedron(inFace)), piercedPairs(octahedron(inFace)));
    EXPECT_EQ(piercedPairs(cutOctahedron({0, -0.4, 0})), 0) << "dented";
}

constexpr int kEnds = 50;

// Far apart and close together, and more than there was room for at the start.
TEST(VertexNumbers, AreThoseThatWereGiven) {
    const std::uint32_t seed = fuzzSeed(111);
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
    const std::uint32_t seed = fuzzSeed(112);
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

constexpr double kEdge = 0.05;
constexpr double kMargin = 6 * kEdge;

/// The box of three points along the axes of the strip.
Bounds boxAlong(const Eigen::Matrix3d& axes, std::initializer_list<Vec3> points) {
    Bounds box;
    for (const Vec3& p : points) {
        box.add(Vec3(axes.transpose() * p));
    }
    return box;
}

// The first queries ask for little, later ones for more: those make it look around once more.
TEST(BroadPhase, FindsAllWithinThePadHoweverMuchWasTakenBefore) {
    constexpr unsigned kBoxSeed = 7;
    SCOPED_TRACE("seed " + std::to_string(kBoxSeed));
    std::mt19937 random{kBoxSeed};
    std::uniform_real_distribution<double> uniform{0, 1};
    const SurfaceMesh mesh = icosphere(4);
    TriangleTree tree(mesh);
    const Blade blade{{-1.3, 0.2, 0.1}, {1.3, 0.3, -0.1}};
    const std::vector<Vec3> points{blade.a, blade.b, {-1.3, 0.2, 0.2}, {1.3, 0.35, 0.05}};
    const auto isCounted = [](int t) { return t % 5 != 0; };
    const cut::BroadPhase broadPhase(mesh, tree, blade, points, kMargin, kEdge, isCounted);
    const Eigen::Matrix3d axes = cut::sweptAxes(blade, points);
    const std::size_t takenAtFirst = broadPhase.entries().size();
    int found = 0;
    for (int i = 0; i < 60; ++i) {
        const double pad = (i < 30 ? 0.01 : 0.9) * kMargin * uniform(random);
        const auto onStrip = [&] {
            const double s = uniform(random);
            const Vec3 low = points[2] + s * (points[3] - points[2]);
            return Vec3(low + uniform(random) * (blade.a + s * (blade.b - blade.a) - low));
        };
        const Vec3 a = onStrip(), b = onStrip(), c = onStrip();
        const std::vector<int> result = broadPhase.query(a, b, c, pad);
        Bounds searched = boxAlong(axes, {a, b, c});
        searched.widen(pad);
        for (int t = 0; t < mesh.triangleSlots(); ++t) {
            const Triangle& corners = mesh.triangle(t);
            const Bounds box = boxAlong(axes, {mesh.position(corners[0]), mesh.position(corners[1]),
                                               mesh.position(corners[2])});
            if (isCounted(t) && box.overlaps(searched)) {
                EXPECT_TRUE(std::ranges::binary_search(result, t)) << t << " in query " << i;
                ++found;
            }
        }
        EXPECT_TRUE(std::ranges::all_of(result, isCounted));
        EXPECT_EQ(std::ranges::adjacent_find(result, std::greater_equal()), result.end());
        if (i < 30) {
            EXPECT_EQ(broadPhase.entries().size(), takenAtFirst);
        }
    }
    EXPECT_GT(broadPhase.entries().size(), takenAtFirst);
    EXPECT_GT(found, 1000);
}

/// What a broad phase finds around a strip through `mesh`, and what that took.
struct Found {
    Found(const SurfaceMesh& mesh, CutSearch way) {
        TriangleTree tree(mesh);
        const Blade blade{{-1.3, 0.02, -1.3}, {1.3, 0.03, -1.3}};
        const std::vector<Vec3> points{blade.a, blade.b, {-1.3, 0.04, 1.3}, {1.3, 0.01, 1.3}};
        const cut::BroadPhase broadPhase(mesh, tree, blade, points, kMargin, kEdge,
                                         [](int) { return true; }, {way, &work});
        broadPhase.takeAround(points, kMargin);
        for (const cut::BroadPhase::Entry& entry : broadPhase.entries()) {
            triangles.push_back(entry.triangle);
        }
    }

    std::vector<int> triangles;
    SearchWork work;
};

TEST(CutSearch, EveryWayFindsTheSame) {
    const TriangleSoup arm = boxSoup({0.2, 2, 0.2}, 6);
    for (const SurfaceMesh& mesh :
         {icosphere(4), torus(), meshOf(joined(arm, arm, {0.5, 0.1, 0.3}))}) {
        const Found tree(mesh, CutSearch::tree);
        const Found adjacency(mesh, CutSearch::adjacency);
        const Found all(mesh, CutSearch::all);
        EXPECT_GT(tree.triangles.size(), 10u);
        EXPECT_EQ(adjacency.triangles, tree.triangles);
        EXPECT_EQ(all.triangles, tree.triangles);
        EXPECT_LT(tree.work.tests, all.work.tests);
        EXPECT_EQ(adjacency.work.tests, all.work.tests) << "to find every group";
        EXPECT_LE(adjacency.work.walkMilliseconds, adjacency.work.milliseconds);
    }
}

// The paper's walk from one seed alone misses the second arm.
TEST(CutSearch, TheWalkNeedsASeedForEachArm) {
    const TriangleSoup arm = boxSoup({0.2, 2, 0.2}, 6);
    // Two searches: the first takes little around the strip, the second all within the margin.
    EXPECT_EQ(Found(meshOf(arm), CutSearch::adjacency).work.seeds, 2 * 1);
    const SurfaceMesh two = meshOf(joined(arm, arm, {0.5, 0.1, 0.3}));
    EXPECT_EQ(Found(two, CutSearch::adjacency).work.seeds, 2 * 2);
    EXPECT_EQ(Found(two, CutSearch::all).work.seeds, 0);
}

}  // namespace
}  // namespace kerf::cut

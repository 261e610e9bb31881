#include "sim/cut/surface/broad_phase.h"

#include <gtest/gtest.h>

#include <random>

#include "sim/cut/exact/directed_edges.h"
#include "sim/mesh/triangle_tree.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

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
    constexpr unsigned kSeed = 7;
    SCOPED_TRACE("seed " + std::to_string(kSeed));
    std::mt19937 random{kSeed};
    std::uniform_real_distribution<double> uniform{0, 1};
    const SurfaceMesh mesh = test::icosphere(4);
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
    const TriangleSoup arm = test::boxSoup({0.2, 2, 0.2}, 6);
    for (const SurfaceMesh& mesh : {test::icosphere(4), test::torus(),
                                    test::meshOf(test::joined(arm, arm, {0.5, 0.1, 0.3}))}) {
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
    const TriangleSoup arm = test::boxSoup({0.2, 2, 0.2}, 6);
    // Two searches: the first takes little around the strip, the second all within the margin.
    EXPECT_EQ(Found(test::meshOf(arm), CutSearch::adjacency).work.seeds, 2 * 1);
    const SurfaceMesh two = test::meshOf(test::joined(arm, arm, {0.5, 0.1, 0.3}));
    EXPECT_EQ(Found(two, CutSearch::adjacency).work.seeds, 2 * 2);
    EXPECT_EQ(Found(two, CutSearch::all).work.seeds, 0);
}

TEST(DirectedEdges, KeepsTheFirstNumberOfAnEdge) {
    cut::DirectedEdges edges(3);
    EXPECT_TRUE(edges.add(0, 1, 5));
    EXPECT_TRUE(edges.add(0, 2, 6));
    EXPECT_TRUE(edges.add(1, 0, 7));
    EXPECT_FALSE(edges.add(0, 1, 8));
    EXPECT_EQ(edges.find(0, 1), 5);
    EXPECT_EQ(edges.find(0, 2), 6);
    EXPECT_EQ(edges.find(1, 0), 7);
    EXPECT_EQ(edges.find(2, 0), -1);
    EXPECT_EQ(edges.find(9, 0), -1);
    EXPECT_FALSE(edges.has(2, 1));
}

TEST(VertexNumbers, FindsWhatWasAddedBeyondItsFirstRoom) {
    cut::VertexNumbers numbers(2);
    for (int i = 0; i < 1000; ++i) {
        EXPECT_EQ(numbers.find(64 * i), -1);
        numbers.add(64 * i, i);
    }
    EXPECT_EQ(numbers.size(), 1000u);
    for (int i = 0; i < 1000; ++i) {
        EXPECT_EQ(numbers.find(64 * i), i);
        EXPECT_EQ(numbers.find(64 * i + 1), -1);
    }
}

}  // namespace
}  // namespace kerf

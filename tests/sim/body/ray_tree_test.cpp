#include <gtest/gtest.h>

#include <random>

#include "sim/body/ispc_builder.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

std::vector<int> allTriangles(const SurfaceMesh& mesh) {
    std::vector<int> slots(mesh.triangleSlots());
    std::iota(slots.begin(), slots.end(), 0);
    return slots;
}

RayHit castAll(const SurfaceMesh& mesh, const std::vector<int>& slots, const Vec3& origin,
               const Vec3& direction) {
    return RayTree(mesh, slots).castToBackFace(origin, direction, 0, [](int) { return true; });
}

/// The answer without a tree: every triangle in a tree of its own.
RayHit castOneByOne(const SurfaceMesh& mesh, const Vec3& origin, const Vec3& direction) {
    RayHit best;
    best.distance = 1e300;
    for (const int slot : allTriangles(mesh)) {
        const RayHit hit = castAll(mesh, {slot}, origin, direction);
        if (hit.triangle >= 0 && hit.distance < best.distance) {
            best = hit;
        }
    }
    return best;
}

TEST(RayTree, FindsTheSameAsTryingEveryTriangle) {
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    const SurfaceMesh mesh = test::bentTube(20, 10);
    const RayTree tree(mesh, allTriangles(mesh));
    int hits = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const Vec3 origin = 0.2 * Vec3(normal(random), normal(random), normal(random));
        const Vec3 direction = Vec3(normal(random), normal(random), normal(random)).normalized();
        const RayHit hit = tree.castToBackFace(origin, direction, 0, [](int) { return true; });
        const RayHit expected = castOneByOne(mesh, origin, direction);
        EXPECT_EQ(hit.triangle, expected.triangle) << "seed 11, trial " << trial;
        hits += hit.triangle >= 0;
    }
    EXPECT_GT(hits, 20);
}

TEST(RayTree, MissesNoRayThroughCornersAndEdges) {
    const SurfaceMesh mesh = test::box(Vec3::Ones(), 4);
    const RayTree tree(mesh, allTriangles(mesh));
    const auto any = [](int) { return true; };
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3 direction = mesh.restPosition(v).normalized();
        const RayHit hit = tree.castToBackFace(Vec3::Zero(), direction, 0, any);
        EXPECT_NEAR(hit.distance, mesh.restPosition(v).norm(), 1e-4) << v;
    }
}

TEST(RayTree, SeesBackFacesOnlyAndHonoursTheNearestDistance) {
    const SurfaceMesh mesh = test::box(Vec3::Ones(), 2);
    const RayTree tree(mesh, allTriangles(mesh));
    const auto any = [](int) { return true; };
    const Vec3 outside(0.1, 0.2, -3);
    EXPECT_NEAR(tree.castToBackFace(outside, Vec3::UnitZ(), 0, any).distance, 3.5, 1e-12);
    EXPECT_EQ(tree.castToBackFace(outside, Vec3::UnitZ(), 3.6, any).triangle, -1);
    EXPECT_EQ(tree.castToBackFace(outside, Vec3::UnitX(), 0, any).triangle, -1);
    EXPECT_EQ(tree.castToBackFace(outside, Vec3::UnitZ(), 0, [](int) { return false; }).triangle,
              -1);
}

TEST(RayTree, SegmentsCrossFromBothSidesButOnlyBetweenTheirEnds) {
    const SurfaceMesh mesh = test::box(Vec3::Ones(), 2);
    const RayTree tree(mesh, allTriangles(mesh));
    EXPECT_TRUE(tree.crosses({0.1, 0.2, 0}, {0.1, 0.2, 1}));
    EXPECT_TRUE(tree.crosses({0.1, 0.2, 1}, {0.1, 0.2, 0}));
    EXPECT_FALSE(tree.crosses({0.1, 0.2, 0}, {0.1, 0.2, 0.4}));
    EXPECT_FALSE(tree.crosses({0.1, 0.2, 2}, {0.1, 0.2, 0.6}));
    EXPECT_FALSE(RayTree(mesh, {}).crosses({0.1, 0.2, 0}, {0.1, 0.2, 1}));
}

TEST(RayTree, CopesWithTrianglesThatAllLieAtOnePlace) {
    TriangleSoup soup = test::boxSoup();
    for (int copies = 0; copies < 6; ++copies) {
        soup = test::joined(soup, soup, Vec3::Zero());
    }
    const SurfaceMesh mesh = test::meshOf(soup);
    const RayHit hit = castAll(mesh, allTriangles(mesh), {0.1, 0.2, 0}, Vec3::UnitX());
    EXPECT_NEAR(hit.distance, 0.4, 1e-12);
}

}  // namespace
}  // namespace kerf

#include "sim/mesh/thickness.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/body_upload.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

TEST(Thickness, OfASlabIsItsHeightOnItsFaces) {
    const SurfaceMesh slab = test::box(Vec3(1, 1, 0.2), 4);
    const std::vector<float> thickness = surfaceThickness(slab);
    ASSERT_EQ(thickness.size(), 2U * slab.vertexCount());
    int inside = 0;
    for (int v = 0; v < slab.vertexCount(); ++v) {
        const Vec3& p = slab.position(v);
        EXPECT_EQ(thickness[2 * v + 1], -1) << "there are no walls";
        if (std::abs(p.x()) < 0.49 && std::abs(p.y()) < 0.49) {
            EXPECT_NEAR(thickness[2 * v], 0.2, 1e-6);
            ++inside;
        }
    }
    EXPECT_GT(inside, 0);
}

TEST(Thickness, OfASphereIsItsDiameterEverywhere) {
    const SurfaceMesh ball = test::icosphere(4, 0.5);
    const std::vector<float> thickness = surfaceThickness(ball);
    for (int v = 0; v < ball.vertexCount(); ++v) {
        EXPECT_NEAR(thickness[2 * v], 1, 0.01);
    }
}

TEST(Thickness, OfARingIsThatOfItsTubeOnItsOutside) {
    const SurfaceMesh ring = test::torus(64, 32, 0.35, 0.15);
    const std::vector<float> thickness = surfaceThickness(ring);
    for (int v = 0; v < ring.vertexCount(); ++v) {
        if (std::hypot(ring.position(v).x(), ring.position(v).z()) > 0.499) {
            EXPECT_NEAR(thickness[2 * v], 0.3, 0.005) << "not that of the whole ring";
        }
    }
}

TEST(Thickness, HasNoGapsAlongTheRimOfACut) {
    const SurfaceMesh opened = test::openedSphere(8, 0.05, 0.25);
    const std::vector<float> thickness = surfaceThickness(opened);
    for (const int t : livingTriangles(opened)) {
        const int kind = opened.kind(t) == SurfaceKind::wall ? 1 : 0;
        for (const int v : opened.triangle(t)) {
            EXPECT_GE(thickness[2 * v + kind], 0) << "vertex " << v << " kind " << kind;
            EXPECT_LE(thickness[2 * v + kind], 1.01);
        }
    }
}

TEST(Thickness, CanBeGivenUp) {
    const SurfaceMesh ball = test::cubeSphere(8);
    EXPECT_THROW(surfaceThickness(ball, [](double) { throw std::runtime_error("enough"); }),
                 std::runtime_error);
}

}  // namespace
}  // namespace kerf

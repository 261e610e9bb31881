#include <gtest/gtest.h>

#include "sim/body/constraint_lists.h"
#include "sim/body/rest_geometry.h"
#include "tests/support/shapes.h"
#include "tests/support/shell_lists.h"

namespace kerf {
namespace {

TEST(RestGeometry, MeanEdgeOfAnIcosahedron) {
    EXPECT_NEAR(meanRestEdgeLength(test::icosphere(0, 0.5)),
                0.5 / std::sin(2 * std::numbers::pi / 5), 1e-12);
}

TEST(ConstraintBuilder, EveryEdgeOnceWithItsLengthAndCrossSection) {
    const SurfaceMesh mesh = test::box(Vec3::Ones(), 1);
    const double thickness = 0.1;
    const auto edges = test::buildEdges(mesh, thickness);
    ASSERT_EQ(edges.size(), 18u);
    for (const auto& e : edges) {
        const double length = (mesh.restPosition(e.a) - mesh.restPosition(e.b)).norm();
        EXPECT_FLOAT_EQ(e.rest_length, length);
        EXPECT_FLOAT_EQ(e.geometry, length * length / (thickness * 1.0));
    }
}

TEST(ConstraintBuilder, BendsOfABoxAreRightAnglesOrFlat) {
    const SurfaceMesh mesh = test::box(Vec3::Ones(), 1);
    int right = 0;
    const auto bends = test::buildBends(mesh, 0.1);
    ASSERT_EQ(bends.size(), 18u);
    for (const auto& b : bends) {
        const bool isRight = std::abs(b.rest_angle - std::numbers::pi / 2) < 1e-6;
        EXPECT_TRUE(isRight || std::abs(b.rest_angle) < 1e-6) << b.rest_angle;
        EXPECT_FLOAT_EQ(b.geometry, 1 / (0.3 * 0.001 / 12));
        right += isRight;
    }
    EXPECT_EQ(right, 12);
}

TEST(ConstraintBuilder, SliversGetEdgesButNoBends) {
    SurfaceMesh mesh = test::box(Vec3::Ones(), 1);
    const int sliver = 0;
    const Triangle t = mesh.triangle(sliver);
    const Vec3 middle = 0.5 * (mesh.restPosition(t[0]) + mesh.restPosition(t[1]));
    mesh.setRestPosition(t[2], middle + 0.01 * (mesh.restPosition(t[2]) - middle));
    EXPECT_EQ(test::buildEdges(mesh, 0.1).size(), 18u);
    const auto bends = test::buildBends(mesh, 0.1);
    EXPECT_LE(bends.size(), 15u);
    for (const auto& b : bends) {
        EXPECT_TRUE(std::isfinite(b.rest_angle));
    }
}

TEST(ConstraintBuilder, AnEdgeWithoutLengthStaysFinite) {
    SurfaceMesh mesh = test::box(Vec3::Ones(), 1);
    mesh.setRestPosition(1, mesh.restPosition(0));
    for (const auto& e : test::buildEdges(mesh, 0.1)) {
        EXPECT_TRUE(std::isfinite(e.geometry) && e.geometry >= 0) << e.a << " " << e.b;
    }
}

}  // namespace
}  // namespace kerf

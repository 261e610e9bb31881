// What leads the blade: the scalpel, the guillotine, and the preview of a cut.
#include <gtest/gtest.h>

#include "app/scene/readout/cut_preview.h"
#include "app/tools/guillotine.h"
#include "app/tools/scalpel.h"
#include "sim/mesh/invariants.h"
#include "tests/support/shapes.h"

namespace kerf::app {
namespace {

constexpr double kRadius = 0.5;

TEST(PickSurface, FindsTheNearSideWithItsNormal) {
    const SurfaceMesh ball = test::cubeSphere(10, kRadius);
    const auto hit = pickSurface(ball, livingTriangles(ball), {Vec3(0.1, 0.2, 3), -Vec3::UnitZ()});
    ASSERT_TRUE(hit.has_value());
    EXPECT_GT(hit->position.z(), 0.4);
    EXPECT_NEAR(hit->position.norm(), kRadius, 0.01);
    EXPECT_GT(hit->normal.dot(hit->position.normalized()), 0.999);
    EXPECT_FALSE(pickSurface(ball, livingTriangles(ball), {Vec3(0.7, 0, 3), -Vec3::UnitZ()}));
    EXPECT_FALSE(pickSurface(ball, livingTriangles(ball), {Vec3(0, 0, 3), Vec3::UnitZ()}));
}

TEST(PickSurface, NoRaySlipsThroughAnEdgeOrACorner) {
    const SurfaceMesh ball = test::cubeSphere(8, kRadius);
    for (int t = 0; t < ball.triangleSlots(); ++t) {
        const Triangle& corners = ball.triangle(t);
        for (const double share : {0.0, 0.3, 0.5}) {
            const Vec3& a = ball.position(corners[0]);
            const Vec3 on = a + share * (ball.position(corners[1]) - a);
            const Vec3 direction = -on.normalized();
            EXPECT_TRUE(pickSurface(ball, livingTriangles(ball), {on - 3 * direction, direction}))
                << t << ", " << share;
        }
    }
}

TEST(CutPreview, APlaneThroughTheBallTouchesABeltAndLeavesACircle) {
    const SurfaceMesh ball = test::cubeSphere(10, kRadius);
    const double x = 0.013;
    const std::vector<Blade> way{
        {{x, 1, -1}, {x, 1, 1}}, {{x, 0, -1}, {x, 0, 1}}, {{x, -1, -1}, {x, -1, 1}}};
    const CutPreview preview = previewCut(ball, livingTriangles(ball), way);
    double length = 0;
    for (const auto& line : preview.wound) {
        EXPECT_NEAR(line[0].x(), x, 2e-4);
        length += (line[1] - line[0]).norm();
    }
    EXPECT_NEAR(length, 2 * EIGEN_PI * kRadius, 0.05);
    for (const int t : preview.touched) {
        double low = 1;
        double high = -1;
        for (const int v : ball.triangle(t)) {
            low = std::min(low, ball.position(v).x());
            high = std::max(high, ball.position(v).x());
        }
        EXPECT_LE(low, x + 2e-4);
        EXPECT_GE(high, x - 2e-4);
    }
    // Along edges of the mesh it is the same circle.
    const std::vector<Blade> middle{{{0, 1, -1}, {0, 1, 1}}, {{0, -1, -1}, {0, -1, 1}}};
    length = 0;
    for (const auto& line : previewCut(ball, livingTriangles(ball), middle).wound) {
        length += (line[1] - line[0]).norm();
    }
    EXPECT_NEAR(length, 2 * EIGEN_PI * kRadius, 0.05);
    const std::vector<Blade> miss{{{1, 1, -1}, {1, 1, 1}}, {{1, -1, -1}, {1, -1, 1}}};
    EXPECT_TRUE(previewCut(ball, livingTriangles(ball), miss).touched.empty());
}

TEST(Scalpel, SwingsInFromTheAirAndStaysUpright) {
    const auto pointAt = [](double angle) {
        const Vec3 normal(std::sin(angle), std::cos(angle), 0);
        return SurfacePoint{0, kRadius * normal, normal};
    };
    Scalpel scalpel(0.1);
    EXPECT_TRUE(scalpel.moveTo(pointAt(0)).empty());
    const std::vector<Blade> in = scalpel.moveTo(pointAt(0.1));
    ASSERT_EQ(in.size(), 4U);
    EXPECT_GT(in[0].a.y(), kRadius);
    EXPECT_GT(in[0].b.y(), kRadius) << "all of the first pose is in the air";
    EXPECT_LT(in[0].b.x(), 0) << "behind the direction of the pull";
    EXPECT_NEAR(in[2].b.norm(), kRadius - 0.1, 1e-12);
    const std::vector<Blade> on = scalpel.moveTo(pointAt(0.3));
    ASSERT_EQ(on.size(), 1U);
    EXPECT_NEAR(on[0].b.norm(), kRadius - 0.1, 1e-12);
    EXPECT_GT(on[0].a.norm(), kRadius);
}

TEST(Guillotine, GoesFromAboveTheBodyToBelowIt) {
    Bounds bounds;
    bounds.add(Vec3(-0.2, 0, -1));
    bounds.add(Vec3(0.2, 0.5, 1));
    const Guillotine guillotine(bounds);
    EXPECT_GT(guillotine.at(0).a.y(), 0.5);
    EXPECT_LT(guillotine.at(1).a.y(), 0);
    EXPECT_LT(guillotine.at(0).a.x(), -0.2) << "across the shorter side";
    EXPECT_GT(guillotine.at(0).b.x(), 0.2);
}

TEST(Guillotine, HandlesMoveTurnAndLengthenIt) {
    Bounds bounds;
    bounds.add(Vec3(-0.5, -0.5, -0.5));
    bounds.add(Vec3(0.5, 0.5, 0.5));
    Guillotine guillotine(bounds);
    const Vec3 middle = guillotine.handles()[Guillotine::middle];
    guillotine.move(Guillotine::endB, middle + Vec3(0, 0, 0.9));
    EXPECT_NEAR((guillotine.at(0).b - (middle + Vec3(0, 0, 0.9))).norm(), 0, 1e-12);
    EXPECT_NEAR(guillotine.length(), 1.8, 1e-12);
    guillotine.move(Guillotine::bottom, middle + Vec3(0.3, -0.4, 0.7));
    EXPECT_NEAR(guillotine.drop(), 0.5, 1e-12) << "square to the blade";
    EXPECT_NEAR((guillotine.at(1).a - guillotine.at(0).a - Vec3(0.3, -0.4, 0)).norm(), 0, 1e-12);
    guillotine.move(Guillotine::middle, Vec3(1, 2, 3));
    EXPECT_NEAR((0.5 * (guillotine.at(0).a + guillotine.at(0).b) - Vec3(1, 2, 3)).norm(), 0, 1e-12);
    guillotine.move(Guillotine::endA, Vec3(1, 2, 3));
    EXPECT_NEAR(guillotine.length(), 1.8, 1e-12) << "a blade keeps a length";
}

}  // namespace
}  // namespace kerf::app

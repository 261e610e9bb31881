#include "app/import/polygon_triangles.h"

namespace kerf::app {
namespace {

using Polygon = std::vector<Vec3>;

constexpr unsigned kStarSeed = 20261126;

Vec3 areaVector(const Polygon& corners, const Triangle& t) {
    return (corners[t[1]] - corners[t[0]]).cross(corners[t[2]] - corners[t[0]]) / 2;
}

/// The triangles cover the area of a flat polygon that faces along `normal`,
/// and none lies on its back.
void expectDivided(const Polygon& corners, const Vec3& normal, double area) {
    const std::vector<Triangle> triangles = triangulatePolygon(corners);
    EXPECT_EQ(triangles.size(), corners.size() - 2);
    double sum = 0;
    for (const Triangle& t : triangles) {
        const double part = areaVector(corners, t).dot(normal);
        EXPECT_GT(part, 0);
        sum += part;
    }
    EXPECT_NEAR(sum, area, 1e-12 * std::max(1.0, area));
}

TEST(PolygonTriangles, AnLWhoseReflexCornerLiesOnTheSideOfAnEar) {
    const Polygon ell{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
    expectDivided(ell, Vec3::UnitZ(), 3);
    const Polygon back(ell.rbegin(), ell.rend());
    expectDivided(back, -Vec3::UnitZ(), 3);
    for (std::size_t first = 1; first < ell.size(); ++first) {
        Polygon turned = ell;
        std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(first),
                    turned.end());
        expectDivided(turned, Vec3::UnitZ(), 3);
    }
}

TEST(PolygonTriangles, CornersOnStraightSidesStay) {
    expectDivided({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {0, 2, 0}, {0, 1, 0}},
                  Vec3::UnitZ(), 4);
}

TEST(PolygonTriangles, StarsInAnyPlaneAreCoveredOnce) {
    std::mt19937 random(kStarSeed);
    std::uniform_real_distribution<double> radius(0.05, 1);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int run = 0; run < 100; ++run) {
        SCOPED_TRACE(testing::Message() << "seed " << kStarSeed << ", run " << run);
        const int count = 5 + static_cast<int>(random() % 60);
        Polygon star;
        for (int i = 0; i < count; ++i) {
            const double angle = 2 * std::numbers::pi * i / count;
            star.emplace_back(radius(random) * Vec3(std::cos(angle), std::sin(angle), 0));
        }
        double area = 0;
        for (int i = 0; i < count; ++i) {
            area += star[i].cross(star[(i + 1) % count]).z() / 2;
        }
        const Vec3 axis = Vec3(any(random), any(random), any(random)).normalized();
        const Eigen::AngleAxisd turn(3 * any(random), axis);
        for (Vec3& p : star) {
            p = turn * p;
        }
        expectDivided(star, turn * Vec3::UnitZ(), area);
    }
}

TEST(PolygonTriangles, AnEdgeMayLeadToAHoleAndBack) {
    const Polygon frame{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                        {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
    expectDivided(frame, Vec3::UnitZ(), 12);
}

TEST(PolygonTriangles, OfABentOneNoCornerIsLost) {
    // Two sides of a cube as one polygon, with corners that hide others along each axis.
    const Polygon bent{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}, {0, 1, 0}};
    EXPECT_EQ(triangulatePolygon(bent).size(), 4u);
}

TEST(PolygonTriangles, WhatCrossesItselfOrIsFlatHasNone) {
    EXPECT_TRUE(triangulatePolygon({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).empty());
    EXPECT_TRUE(triangulatePolygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}}).empty());
    Polygon pentagram;
    for (int i = 0; i < 5; ++i) {
        const double angle = 4 * std::numbers::pi * i / 5;
        pentagram.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    EXPECT_TRUE(triangulatePolygon(pentagram).empty());
}

TEST(PolygonTriangles, WhatTouchesItselfHasNone) {
    // The fifth corner lies on the first side.
    EXPECT_TRUE(
        triangulatePolygon({{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {3, 2, 0}, {2, 0, 0}, {0, 2, 0}})
            .empty());
}

}  // namespace
}  // namespace kerf::app

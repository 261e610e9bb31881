#include "sim/mesh/winding.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/shapes.h"

namespace kerf {
namespace {

constexpr unsigned kRaySeed = 20261126;

int windingAt(const TriangleSoup& soup, const Vec3& point) {
    int winding = 0;
    for (const auto& [a, b, c] : soup.triangles) {
        winding += rayCrossing({soup.positions[a], soup.positions[b], soup.positions[c]}, point);
    }
    return winding;
}

TEST(Winding, RaysThroughEdgesVerticesAndPlanesCountOnce) {
    // On this grid rays run through vertices, along edges and within faces.
    const TriangleSoup box = test::boxSoup(Vec3::Constant(4), 4);
    for (int x = -3; x <= 3; ++x) {
        for (int y = -3; y <= 3; ++y) {
            for (int z = -3; z <= 3; ++z) {
                const Vec3 point(x, y, z);
                const int outermost = point.cwiseAbs().maxCoeff();
                const int winding = windingAt(box, point);
                SCOPED_TRACE(point.transpose());
                if (outermost == 2) {
                    EXPECT_TRUE(winding == 0 || winding == 1) << winding;
                } else {
                    EXPECT_EQ(winding, outermost < 2 ? 1 : 0);
                }
            }
        }
    }
}

TEST(Winding, PointsOfTheSurfaceLieOnOneSideOfIt) {
    std::mt19937 random(kRaySeed);
    std::uniform_int_distribution<int> share(0, 8);
    TriangleSoup ball = test::icosphereSoup(2, 1);
    for (int run = 0; run < 200; ++run) {
        SCOPED_TRACE(testing::Message() << "seed " << kRaySeed << ", run " << run);
        const Triangle& t = ball.triangles[random() % ball.triangles.size()];
        const double first = share(random) / 8.0;
        const double second = (1 - first) * share(random) / 8.0;
        const Vec3 point = first * ball.positions[t[0]] + second * ball.positions[t[1]] +
                           (1 - first - second) * ball.positions[t[2]];
        const int winding = windingAt(ball, point);
        EXPECT_TRUE(winding == 0 || winding == 1) << winding;
        EXPECT_EQ(windingAt(test::turned(ball), point), -winding);
    }
}

}  // namespace
}  // namespace kerf

#include <gtest/gtest.h>

#include <random>

#include "sim/base/math.h"
#include "sim/body/rest_geometry.h"

namespace kerf {
namespace {

using Hinge = std::array<Vec3, 4>;

double angleOf(const Hinge& x) {
    return dihedral<double>(x[1] - x[0], x[2] - x[0], x[3] - x[0]).angle;
}

// Edge along x, apexes left and right, both lowered by `drop`: convex seen from above for drop > 0.
Hinge roof(double drop) {
    return {Vec3(0, 0, 0), {1, 0, 0}, {0.4, -drop, -1}, {0.6, -drop, 1}};
}

TEST(Dihedral, FlatIsZeroConvexIsPositiveConcaveNegative) {
    EXPECT_NEAR(angleOf(roof(0)), 0, 1e-15);
    EXPECT_NEAR(angleOf(roof(1)), std::numbers::pi / 2, 1e-12);
    EXPECT_NEAR(angleOf(roof(-1)), -std::numbers::pi / 2, 1e-12);
}

TEST(Dihedral, GradientAgreesWithFiniteDifferences) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> noise(-0.3, 0.3);
    const double step = 1e-6;
    for (int trial = 0; trial < 50; ++trial) {
        Hinge x = roof(2 * noise(random));
        for (Vec3& p : x) {
            p += Vec3(noise(random), noise(random), noise(random));
        }
        const auto exact = dihedral<double>(x[1] - x[0], x[2] - x[0], x[3] - x[0]);
        ASSERT_TRUE(exact.valid);
        for (int v = 0; v < 4; ++v) {
            for (int axis = 0; axis < 3; ++axis) {
                Hinge forward = x;
                Hinge back = x;
                forward[v][axis] += step;
                back[v][axis] -= step;
                const double slope = wrapAngle(angleOf(forward) - angleOf(back)) / (2 * step);
                EXPECT_NEAR(exact.gradient[v][axis], slope, 1e-6) << "seed 7, trial " << trial;
            }
        }
    }
}

TEST(Dihedral, CollinearPointsAreInvalidAndGiveNoNumber) {
    const auto folded = dihedral<double>(Vec3(1, 0, 0), Vec3(0.5, 0, 0), Vec3(0, 0, 1));
    EXPECT_FALSE(folded.valid);
    EXPECT_FALSE(dihedral<float>(Vec3f::Zero(), Vec3f::UnitX(), Vec3f::UnitZ()).valid);
}

TEST(Dihedral, DifferencesOfAnglesWrap) {
    EXPECT_NEAR(wrapAngle(1.9 * std::numbers::pi), -0.1 * std::numbers::pi, 1e-12);
    EXPECT_NEAR(wrapAngle(-1.9 * std::numbers::pi), 0.1 * std::numbers::pi, 1e-12);
    EXPECT_EQ(wrapAngle(0.5), 0.5);
}

}  // namespace
}  // namespace kerf

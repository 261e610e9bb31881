#include <gtest/gtest.h>

#include "sim/mesh/triangle_quality.h"

namespace kerf {
namespace {

const Corners kRest{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0.5, 1, 0)};

Corners mapped(const Eigen::Matrix3d& map) {
    Corners corners = kRest;
    for (Vec3& corner : corners) {
        corner = map * corner + Vec3(3, -1, 7);
    }
    return corners;
}

TEST(TriangleStrain, IsThatOfTheLargerPrincipalStretch) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    const auto stretched = [&](double x, double y) {
        return largestStrain(kRest, mapped(turn * Eigen::Vector3d(x, y, 1).asDiagonal()));
    };
    EXPECT_NEAR(stretched(1, 1), 0, 1e-7);
    EXPECT_NEAR(stretched(1.25, 1), 0.25, 1e-12);
    EXPECT_NEAR(stretched(1.1, 0.6), 0.4, 1e-12) << "by amount";
    EXPECT_NEAR(stretched(1, 0), 1, 1e-7) << "flat";
}

TEST(TriangleStrain, OfAShearIsThatOfItsStretch) {
    Eigen::Matrix3d shear = Eigen::Matrix3d::Identity();
    shear(0, 1) = 1;
    const double golden = (1 + std::sqrt(5.0)) / 2;
    EXPECT_NEAR(largestStrain(kRest, mapped(shear)), golden - 1, 1e-12);
}

TEST(TriangleStrain, IsNoneWithoutAreaAtRest) {
    EXPECT_EQ(largestStrain({Vec3::Zero(), Vec3::UnitX(), 2 * Vec3::UnitX()}, kRest), 0);
}

}  // namespace
}  // namespace kerf

#include <gtest/gtest.h>

#include "sim/base/placement.h"

namespace kerf {
namespace {

TEST(Turn, AnglesOfARotationMakeItAgain) {
    for (const double x : {-170.0, -90.0, 0.0, 35.0, 180.0}) {
        for (const double y : {-90.0, -89.0, 0.0, 60.0, 90.0, 140.0}) {
            for (const double z : {-120.0, 0.0, 77.0, 180.0}) {
                const Eigen::Matrix3d turn = turnOf(Vec3(x, y, z));
                EXPECT_LT((turnOf(turnsOf(turn)) - turn).norm(), 1e-6) << x << " " << y << " " << z;
            }
        }
    }
}

TEST(Turn, SmallAnglesStayAsTheyAre) {
    EXPECT_LT((turnsOf(turnOf(Vec3(10, -20, 30))) - Vec3(10, -20, 30)).norm(), 1e-9);
}

}  // namespace
}  // namespace kerf

#include "sim/mesh/oriented_box.h"

#include <gtest/gtest.h>

#include <random>

namespace kerf {
namespace {

class OrientedBoxes : public ::testing::Test {
  protected:
    std::mt19937_64 random{20251120};
    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    }
    Vec3 randomPoint(double size) {
        return {uniform(-size, size), uniform(-size, size), uniform(-size, size)};
    }
    OrientedBox randomBox() {
        const Vec3 axis = randomPoint(1).normalized();
        const Eigen::AngleAxisd turn(uniform(0, 6.28), axis);
        return {randomPoint(1.2), turn.toRotationMatrix(),
                Vec3(uniform(0, 1), uniform(0, 1), uniform(0, 0.3))};
    }
};

Vec3 closestIn(const OrientedBox& box, const Vec3& p) {
    const Vec3 local = box.axes.transpose() * (p - box.center);
    return box.center + box.axes * Vec3(local.cwiseMax(-box.half).cwiseMin(box.half));
}

/// Distance of two boxes by projecting to and fro, which converges for convex sets.
double distance(const OrientedBox& a, const OrientedBox& b) {
    Vec3 p = a.center;
    Vec3 q = b.center;
    for (int i = 0; i < 20000; ++i) {
        q = closestIn(b, p);
        p = closestIn(a, q);
    }
    return (p - q).norm();
}

TEST_F(OrientedBoxes, OverlapExactlyWhereTheirDistanceIsZero) {
    int apart = 0;
    int together = 0;
    for (int i = 0; i < 300; ++i) {
        const OrientedBox a = randomBox();
        const OrientedBox b = randomBox();
        const double gap = distance(a, b);
        if (gap > 1e-3) {
            ++apart;
            EXPECT_FALSE(overlap(a, b)) << "pair " << i << " of seed 20251120, gap " << gap;
        } else if (gap < 1e-7) {
            ++together;
            EXPECT_TRUE(overlap(a, b)) << "pair " << i << " of seed 20251120";
        }
        EXPECT_EQ(overlap(a, b), overlap(b, a));
    }
    EXPECT_GT(apart, 50);
    EXPECT_GT(together, 30);
}

TEST_F(OrientedBoxes, EdgesAcrossNeedTheAxisAcrossBoth) {
    // Two bars, one turned by 90 degrees, edges facing each other: only the cross product of the
    // edges separates them.
    OrientedBox a{Vec3::Zero(), Eigen::Matrix3d::Identity(), Vec3(1, 0.1, 0.1)};
    a.axes = Eigen::AngleAxisd(0.785398, Vec3::UnitX()).toRotationMatrix();
    OrientedBox b{Vec3(0, 0, 0.29), Eigen::Matrix3d::Identity(), Vec3(0.1, 1, 0.1)};
    b.axes = Eigen::AngleAxisd(0.785398, Vec3::UnitY()).toRotationMatrix();
    EXPECT_FALSE(overlap(a, b));
    b.center.z() = 0.27;
    EXPECT_TRUE(overlap(a, b));
}

TEST_F(OrientedBoxes, ThatMeetOneOfManyAreNotMissed) {
    int found = 0;
    int told = 0;
    for (int i = 0; i < 50; ++i) {
        const OrientedBox box = randomBox();
        const MeetingBoxes meeting(box);
        for (int k = 0; k < 200; ++k) {
            const Vec3 low = randomPoint(2);
            const Bounds bounds{low, low + randomPoint(0.5).cwiseAbs()};
            const bool meets = meeting.mayMeet(bounds);
            told += mayMeet(box, bounds);
            found += meets;
            EXPECT_TRUE(meets || !mayMeet(box, bounds)) << "pair " << i << ", " << k;
        }
    }
    EXPECT_GT(told, 100);
    EXPECT_LE(found, told + told / 100);
}

TEST_F(OrientedBoxes, ParallelOnesThatTouchOverlap) {
    const OrientedBox a{Vec3::Zero(), Eigen::Matrix3d::Identity(), Vec3(1, 1, 1)};
    OrientedBox b = a;
    b.center.x() = 2;
    EXPECT_TRUE(overlap(a, b));
    b.center.x() = 2.001;
    EXPECT_FALSE(overlap(a, b));
}

TEST_F(OrientedBoxes, HoldTheirPointsAndFollowTheirSpread) {
    for (int i = 0; i < 50; ++i) {
        const OrientedBox around = randomBox();
        std::vector<Vec3> points;
        points.reserve(200);
        for (int k = 0; k < 200; ++k) {
            points.push_back(around.center + around.axes * Vec3(uniform(-4, 4), uniform(-1, 1),
                                                                uniform(-0.1, 0.1)));
        }
        const OrientedBox box = orientedBoxOf(points);
        for (const Vec3& p : points) {
            const Vec3 local = (box.axes.transpose() * (p - box.center)).cwiseAbs();
            EXPECT_TRUE((local.array() <= box.half.array() + 1e-12).all());
        }
        EXPECT_LT(box.half.prod(), 2 * 4 * 1 * 0.1) << "set " << i << " of seed 20251120";
    }
}

TEST_F(OrientedBoxes, OfOnePointAndOfALine) {
    const std::vector<Vec3> point{Vec3(1, 2, 3)};
    EXPECT_EQ(orientedBoxOf(point).half, Vec3::Zero());
    const std::vector<Vec3> line{Vec3(0, 0, 0), Vec3(1, 1, 0)};
    const OrientedBox box = orientedBoxOf(line);
    EXPECT_NEAR(box.half.maxCoeff(), std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(box.half.minCoeff(), 0, 1e-12);
}

}  // namespace
}  // namespace kerf

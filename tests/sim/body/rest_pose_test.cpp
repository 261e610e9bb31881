#include <gtest/gtest.h>

#include "sim/body/rest_geometry.h"

namespace kerf {
namespace {

const std::vector<Vec3> kCorners{{1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {-1, -2, 1}};

/// With weights 1, 2, 3, 4, moving with `motion` about their middle.
std::vector<FittedVertex> turned(const Eigen::Matrix3d& rotation, const Vec3& shift) {
    std::vector<FittedVertex> vertices;
    for (const Vec3& rest : kCorners) {
        const int number = static_cast<int>(vertices.size());
        vertices.push_back({number, number + 1.0, rotation * rest + shift, rest, Vec3::Zero()});
    }
    return vertices;
}

TEST(RestPose, OfARigidMotionIsThatMotion) {
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(2.5, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    const std::vector<FittedVertex> vertices = turned(rotation, {4, 5, 6});
    const RestPose pose = fitRestPose(vertices);
    EXPECT_LT((pose.rotation - rotation).norm(), 1e-12);
    for (const FittedVertex& v : vertices) {
        EXPECT_LT((pose.placeOf(v.rest) - v.at).norm(), 1e-12);
    }
    EXPECT_LT(rmsWay(pose, vertices), 1e-12);
    EXPECT_GT(pose.radius, 1);
}

TEST(RestPose, NeverMirrors) {
    Eigen::Matrix3d mirror = Eigen::Matrix3d::Identity();
    mirror(0, 0) = -1;
    const std::vector<FittedVertex> vertices = turned(mirror, Vec3::Zero());
    const RestPose pose = fitRestPose(vertices);
    EXPECT_NEAR(pose.rotation.determinant(), 1, 1e-12);
    EXPECT_GT(rmsWay(pose, vertices), 0.3);
}

TEST(RestPose, WaysToItHaveNoMomentum) {
    std::vector<FittedVertex> vertices = turned(Eigen::Matrix3d::Identity(), Vec3::Zero());
    vertices[1].at += Vec3(0.3, -2, 0.4);
    vertices[2].at *= -0.5;
    const RestPose pose = fitRestPose(vertices);
    for (FittedVertex& v : vertices) {
        v.velocity = pose.placeOf(v.rest) - v.at;
    }
    const RigidMotion motion = rigidMotionOf(vertices, pose.middle);
    EXPECT_LT(motion.velocity.norm(), 1e-12);
    EXPECT_LT(motion.spin.norm(), 1e-5);
}

TEST(RestPose, MotionAsAWholeIsFound) {
    std::vector<FittedVertex> vertices = turned(Eigen::Matrix3d::Identity(), Vec3::Zero());
    const Vec3 middle = fitRestPose(vertices).middle;
    const Vec3 spin(0.1, -2, 3);
    for (FittedVertex& v : vertices) {
        v.velocity = Vec3(7, 8, 9) + spin.cross(v.at - middle);
    }
    const RigidMotion motion = rigidMotionOf(vertices, middle);
    EXPECT_LT((motion.velocity - Vec3(7, 8, 9)).norm(), 1e-12);
    EXPECT_LT((motion.spin - spin).norm(), 1e-4);
}

TEST(RestPose, OfAPointAloneMovesWithIt) {
    const std::vector<FittedVertex> one{{0, 2, {1, 2, 3}, {0, 0, 0}, {4, 5, 6}}};
    EXPECT_EQ(fitRestPose(one).placeOf(Vec3::Zero()), Vec3(1, 2, 3));
    EXPECT_EQ(rigidMotionOf(one, one[0].at).velocity, Vec3(4, 5, 6));
    EXPECT_EQ(rigidMotionOf(one, one[0].at).spin, Vec3::Zero());
}

}  // namespace
}  // namespace kerf

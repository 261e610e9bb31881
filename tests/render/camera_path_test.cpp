#include <gtest/gtest.h>

#include "render/scene/camera.h"

namespace kerf::render {
namespace {

Camera from(const Vec3& eye, const Vec3& target = Vec3::Zero()) {
    Camera camera;
    camera.eye = eye;
    camera.target = target;
    return camera;
}

double apart(const Camera& a, const Camera& b) {
    return (a.eye - b.eye).norm() + (a.target - b.target).norm();
}

TEST(CameraPath, RestsAtItsKeysAndBesideThem) {
    const Camera front = from({0, 0, 4});
    const Camera side = from({8, 0, 0}, {0, 1, 0});
    const CameraPath path({{10, front}, {30, side}});
    EXPECT_LT(apart(path.at(0), front), 1e-9);
    EXPECT_LT(apart(path.at(10), front), 1e-9);
    EXPECT_LT(apart(path.at(30), side), 1e-6);
    EXPECT_LT(apart(path.at(99), side), 1e-9);
    // Near a key it is slow, half way it is fast.
    EXPECT_LT(apart(path.at(10), path.at(11)), 0.2 * apart(path.at(19.5), path.at(20.5)));
}

TEST(CameraPath, TurnsAboutItsTargetInsteadOfGoingThroughIt) {
    const CameraPath path({{0, from({0, 0, 2})}, {10, from({8, 0, 0})}});
    const Camera middle = path.at(5);
    EXPECT_NEAR((middle.eye - middle.target).norm(), 4, 1e-6) << "the distance in equal ratios";
    EXPECT_NEAR(middle.eye.x(), middle.eye.z(), 1e-6) << "half of the turn";
    EXPECT_NEAR(middle.eye.y(), 0, 1e-6);
    EXPECT_NEAR(middle.up.y(), 1, 1e-6);
}

TEST(CameraPath, TakesTheLastOfSeveralKeysAtOneMoment) {
    const Camera front = from({0, 0, 4});
    const Camera side = from({4, 0, 0});
    const CameraPath path({{5, front}, {5, side}, {9, front}});
    EXPECT_LT(apart(path.at(5), side), 1e-9);
    EXPECT_LT(apart(path.at(4.9), front), 1e-9) << "a picture cut from one view to the other";
    EXPECT_LT(apart(path.at(9), front), 1e-9);
}

TEST(CameraPath, WithoutKeysIsEmpty) {
    EXPECT_TRUE(CameraPath().empty());
    EXPECT_FALSE(CameraPath({{0, from({0, 0, 4})}}).empty());
}

}  // namespace
}  // namespace kerf::render

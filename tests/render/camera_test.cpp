#include "render/scene/camera.h"

namespace kerf::render {
namespace {

Vec3 project(const Camera& camera, const Vec3& point, double aspect) {
    const Eigen::Vector4f clip =
        camera.projection(aspect) * camera.view() * Vec3f(point.cast<float>()).homogeneous();
    return clip.head<3>().cast<double>() / double(clip.w());
}

Bounds unitBox() {
    return {Vec3(-1, -1, -1), Vec3(1, 1, 1)};
}

double elevation(const Camera& camera) {
    return std::asin((camera.eye - camera.target).normalized().y());
}

TEST(Camera, RayIsTheInverseOfTheProjection) {
    Camera camera;
    for (const Vec2& ndc : {Vec2(0, 0), Vec2(0.7, -0.4), Vec2(-0.9, 0.95)}) {
        const Vec3 point = camera.eye + 3.7 * camera.ray(ndc, 1.5).direction;
        const Vec3 back = project(camera, point, 1.5);
        EXPECT_NEAR(back.x(), ndc.x(), 1e-5);
        EXPECT_NEAR(back.y(), ndc.y(), 1e-5);
    }
    EXPECT_NEAR(camera.ray({0.3, 0.1}, 1.5).direction.norm(), 1, 1e-12);
}

TEST(Camera, OrthographicRaysAreParallelAndTheInverseOfTheProjection) {
    Camera camera;
    camera.orthographic = true;
    for (const Vec2& ndc : {Vec2(0, 0), Vec2(0.7, -0.4), Vec2(-0.9, 0.95)}) {
        const Ray ray = camera.ray(ndc, 1.5);
        EXPECT_NEAR((ray.direction - camera.forward()).norm(), 0, 1e-12);
        for (const double along : {1.0, 30.0, 150.0}) {
            const Vec3 back = project(camera, ray.origin + along * ray.direction, 1.5);
            EXPECT_NEAR(back.x(), ndc.x(), 1e-4);
            EXPECT_NEAR(back.y(), ndc.y(), 1e-4);
            EXPECT_LT(std::abs(back.z()), 1) << "inside the depth range";
        }
    }
}

TEST(Camera, BothKindsShowThePlaneOfTheTargetAlike) {
    Camera camera;
    Camera flat = camera;
    flat.orthographic = true;
    const double depth = (camera.eye - camera.target).norm();
    const Vec3 point = camera.pointAt({0.6, -0.3}, 1.5, depth);
    EXPECT_NEAR((point - flat.pointAt({0.6, -0.3}, 1.5, depth)).norm(), 0, 1e-9);
    EXPECT_NEAR((project(camera, point, 1.5) - project(flat, point, 1.5)).head<2>().norm(), 0,
                1e-5);
    const Vec3 before = flat.pointAt({0.6, -0.3}, 1.5, 0.1 * depth);
    EXPECT_NEAR((before - point).cross(flat.forward()).norm(), 0, 1e-9);
}

TEST(Camera, VerticalFieldOfViewSpansTheHeight) {
    Camera camera;
    camera.eye = Vec3(0, 0, 5);
    camera.fovY = 60;
    const double half = 5 * std::tan(30 * std::numbers::pi / 180);
    EXPECT_NEAR(project(camera, Vec3(0, half, 0), 2).y(), 1, 1e-5);
    EXPECT_NEAR(project(camera, Vec3(2 * half, 0, 0), 2).x(), 1, 1e-5);
}

TEST(Camera, OrbitKeepsDistanceAndStopsBeforeThePoles) {
    Camera camera;
    const double before = (camera.eye - camera.target).norm();
    camera.orbit(0.8, 0.2);
    EXPECT_NEAR((camera.eye - camera.target).norm(), before, 1e-9);
    camera.orbit(0, 10);
    EXPECT_GT(elevation(camera), 1.5);
    EXPECT_LT(elevation(camera), 0.5 * std::numbers::pi);
    camera.orbit(0, -20);
    EXPECT_LT(elevation(camera), -1.5);
    EXPECT_GT(elevation(camera), -0.5 * std::numbers::pi);
}

TEST(Camera, OrbitLeavesAStraightViewFromAbove) {
    Camera camera;
    camera.eye = Vec3(0, 5, 0);
    EXPECT_TRUE(camera.view().allFinite());
    camera.orbit(0, -0.5);
    EXPECT_LT(elevation(camera), 1.3);
    EXPECT_NEAR(camera.eye.norm(), 5, 1e-9);
}

TEST(Camera, OrbitByYawAndPitchTurnsByTheseAngles) {
    Camera camera;
    camera.eye = Vec3(0, 0, 4);
    camera.orbit(0.5, 0.3);
    EXPECT_NEAR(elevation(camera), 0.3, 1e-9);
    EXPECT_NEAR(std::atan2(camera.eye.x(), camera.eye.z()), 0.5, 1e-9);
}

TEST(Camera, PanMovesTheTargetByAShareOfTheViewHeight) {
    Camera camera;
    const Vec3 target = camera.target;
    camera.pan(0.1, -0.25);
    const Vec3 ndc = project(camera, target, 1);
    EXPECT_NEAR(ndc.x(), -0.2, 1e-5);
    EXPECT_NEAR(ndc.y(), 0.5, 1e-5);
}

TEST(Camera, ZoomKeepsThePointUnderThePointer) {
    for (const bool orthographic : {false, true}) {
        Camera camera;
        camera.orthographic = orthographic;
        const Vec2 pointer(0.4, -0.3);
        const double distance = (camera.target - camera.eye).norm();
        const Vec3 under = camera.pointAt(pointer, 1.6, distance);
        camera.zoom(0.5, pointer, 1.6);
        EXPECT_NEAR((camera.target - camera.eye).norm(), 0.5 * distance, 1e-9);
        const Vec3 ndc = project(camera, under, 1.6);
        EXPECT_NEAR(ndc.x(), pointer.x(), 1e-5);
        EXPECT_NEAR(ndc.y(), pointer.y(), 1e-5);
    }
}

TEST(Camera, FrameFillsTheViewWithTheBounds) {
    Camera camera;
    const Vec3 direction = (camera.target - camera.eye).normalized();
    camera.frame(unitBox());
    EXPECT_NEAR((camera.target - camera.eye).normalized().dot(direction), 1, 1e-12);
    double reach = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 point(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
        const Vec3 ndc = project(camera, point, 1);
        reach = std::max({reach, std::abs(ndc.x()), std::abs(ndc.y())});
    }
    EXPECT_LE(reach, 1 + 1e-5);
    EXPECT_GT(reach, 0.9);
    const Vec3 eye = camera.eye;
    camera.frame(Bounds{});
    EXPECT_EQ(camera.eye, eye) << "nothing to frame";
    camera.frame(unitBox(), 0.5);
    EXPECT_GT((camera.eye - camera.target).norm(), 1.5 * (eye - camera.target).norm())
        << "in half of the height";
}

TEST(Camera, LooksAtItsTargetInTheMiddleOrElsewhere) {
    for (const bool orthographic : {false, true}) {
        for (const Vec2& middle : {Vec2(0, 0), Vec2(0.2, -0.1)}) {
            Camera camera;
            camera.orthographic = orthographic;
            camera.middle = middle;
            const Vec3 ndc = project(camera, camera.target, 1.5);
            EXPECT_LT((ndc.head<2>() - middle).norm(), 1e-5);
            EXPECT_LT(std::abs(ndc.z()), 1);
            const Ray ray = camera.ray(camera.middle, 1.5);
            EXPECT_NEAR((camera.target - ray.origin).cross(ray.direction).norm(), 0, 1e-9);
        }
    }
}

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

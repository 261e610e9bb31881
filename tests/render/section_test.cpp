// A plane that opens the picture of a body: what is hidden, and what is filled.
#include <gtest/gtest.h>

#include "render/renderer.h"
#include "tests/render/light_renderer_test.h"
#include "tests/render/stage.h"
#include "tests/support/shapes.h"

namespace kerf::render {
namespace {

constexpr double kViewHeight = 2;  // of the picture at the target [m]

class SectionTest : public LightRendererTest {
  protected:
    /// Straight at the plane, on nothing.
    Image lookAt(Stage& stage, const SectionPlane& plane) {
        stage.scene.section = plane;
        stage.scene.floor.reset();
        stage.scene.transparent = true;
        stage.scene.bodyRevision = 1;
        stage.camera.orthographic = true;
        stage.camera.target = Vec3::Zero();
        stage.camera.eye = 3 * plane.normal;
        stage.camera.up = std::abs(plane.normal.y()) > 0.5 ? Vec3(0, 0, 1) : Vec3(0, 1, 0);
        stage.camera.fovY = 2 * std::atan(kViewHeight / 2 / 3) * 180 / std::numbers::pi;
        return stage.picture(*renderer_);
    }
    static double areaOf(long pixels) {
        const double side = kViewHeight / kHeight;
        return double(pixels) * side * side;
    }
    static long covered(const Image& image) {
        long count = 0;
        for (std::size_t i = 3; i < image.pixels.size(); i += 4) {
            count += image.pixels[i] > 127 ? 1 : 0;
        }
        return count;
    }
};

std::size_t byteAt(double x, double y) {
    const double perPixel = kViewHeight / kHeight;
    const auto column = static_cast<std::size_t>(0.5 * kWidth + x / perPixel);
    const auto row = static_cast<std::size_t>(0.5 * kHeight - y / perPixel);
    return 4 * (row * kWidth + column);
}

/// Pixels of the flat grey with which a section is filled where colours show a quantity, by one of
/// them at (x, y) [m].
long greyPixels(const Image& image, double x = 0, double y = 0) {
    const std::size_t sample = byteAt(x, y);
    long count = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
        bool same = image.pixels[i + 3] == 255;
        for (int c = 0; c < 3; ++c) {
            same = same && std::abs(image.pixels[i + c] - image.pixels[sample + c]) <= 2;
        }
        count += same ? 1 : 0;
    }
    return count;
}

TEST_F(SectionTest, OfACubeIsFilledWithTheAreaOfItsSection) {
    Stage stage(test::box(Vec3(1, 1, 1), 2));
    stage.scene.field.choice.field =
        SurfaceField::strain;  // the cap is grey then, and the cube not
    for (const double offset : {0.0, 0.3}) {
        const Image image = lookAt(stage, {Vec3(0, 0, offset), Vec3::UnitZ()});
        EXPECT_NEAR(areaOf(greyPixels(image)), 1, 0.02) << offset;
    }
    const Vec3 slanted = Vec3(0, 1, 1).normalized();
    EXPECT_NEAR(areaOf(greyPixels(lookAt(stage, {Vec3::Zero(), slanted}))), std::sqrt(2), 0.03);
}

TEST_F(SectionTest, OfASphereIsTheDiscAtItsHeight) {
    Stage stage(test::icosphere(4, 0.5));
    stage.scene.field.choice.field = SurfaceField::strain;
    const Image image = lookAt(stage, {Vec3(0, 0, 0.3), Vec3::UnitZ()});
    EXPECT_NEAR(areaOf(greyPixels(image)), std::numbers::pi * 0.16, 0.01);
}

TEST_F(SectionTest, OfARingLeavesItsHoleOpen) {
    Stage stage(test::torus(64, 32, 0.35, 0.15));
    stage.scene.field.choice.field = SurfaceField::strain;
    const Image across = lookAt(stage, {Vec3::Zero(), Vec3::UnitZ()});
    const double disc = std::numbers::pi * 0.15 * 0.15;
    EXPECT_NEAR(areaOf(greyPixels(across, 0.35, 0)), 2 * disc, 0.01);
    const Image along = lookAt(stage, {Vec3::Zero(), Vec3::UnitY()});
    EXPECT_EQ(along.pixels[byteAt(0, 0) + 3], 0) << "one looks through the ring";
    const double ring = std::numbers::pi * (0.5 * 0.5 - 0.2 * 0.2);
    EXPECT_NEAR(areaOf(greyPixels(along, 0.35, 0)), ring, 0.03);
}

TEST_F(SectionTest, HidesTheSideThatTheNormalPointsTo) {
    Stage stage(test::box(Vec3(1, 1, 1), 2));
    const Image all = lookAt(stage, {Vec3(0, 0, 0.6), Vec3::UnitZ()});
    EXPECT_NEAR(areaOf(covered(all)), 1, 0.02);
    const Image none = lookAt(stage, {Vec3(0, 0, -0.6), Vec3::UnitZ()});
    EXPECT_EQ(covered(none), 0);
}

TEST_F(SectionTest, BothHalvesOfACutBodyAreFilled) {
    Stage stage(test::openedSphere(10, 0.2, 0));
    stage.scene.field.choice.field = SurfaceField::strain;
    const Image image = lookAt(stage, {Vec3::Zero(), Vec3::UnitX()});
    // Two half discs of radius 1, of which the picture shows what is less than 1 from its middle.
    EXPECT_GT(areaOf(covered(image)), 2.5);
    EXPECT_EQ(image.pixels[byteAt(0, 0) + 3], 0) << "the gap between them is open";
}

TEST_F(SectionTest, WithoutOneThePictureIsThatOfBefore) {
    Stage stage(test::openedSphere(8, 0.05, 0.25));
    stage.scene.bodyRevision = 1;
    const Image before = stage.picture(*renderer_);
    stage.scene.section = SectionPlane{};
    EXPECT_NE(stage.picture(*renderer_).pixels, before.pixels);
    stage.scene.section.reset();
    EXPECT_EQ(stage.picture(*renderer_).pixels, before.pixels);
}

}  // namespace
}  // namespace kerf::render

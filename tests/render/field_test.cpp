// Quantities as colours on the surface: their numbers against what analysis says.
#include <gtest/gtest.h>

#include "render/renderer.h"
#include "sim/mesh/invariants.h"
#include "tests/render/light_renderer_test.h"
#include "tests/render/stage.h"
#include "tests/support/shapes.h"

namespace kerf::render {
namespace {

/// The mesh with each vertex mapped to where it is now.
template <class Map>
SurfaceMesh moved(SurfaceMesh mesh, Map&& map) {
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        mesh.setPosition(v, map(mesh.restPosition(v)));
    }
    return mesh;
}

class FieldTest : public LightRendererTest {
  protected:
    Image show(Stage& stage, SurfaceField field) {
        stage.scene.field.choice.field = field;
        stage.scene.bodyRevision = 1;
        return stage.picture(*renderer_);
    }
    float at(int vertex, bool wall = false) {
        return renderer_->fieldAt(1, static_cast<std::uint32_t>(vertex), wall).value_or(-1);
    }
};

/// A vertex in the middle of the face towards +z.
int middleOfFront(const SurfaceMesh& mesh) {
    const double front = meshBounds(mesh).high.z();
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if ((mesh.restPosition(v) - Vec3(0, 0, front)).norm() < 1e-9) {
            return v;
        }
    }
    return -1;
}

TEST_F(FieldTest, AStretchedSlabHasTheStrainOfItsStretch) {
    const SurfaceMesh slab = test::box(Vec3(1, 1, 0.2), 4);
    Stage stage(moved(slab, [](const Vec3& p) { return Vec3(1.1 * p.x(), 0.95 * p.y(), p.z()); }));
    show(stage, SurfaceField::strain);
    EXPECT_NEAR(at(middleOfFront(slab)), 0.1, 1e-5);
    EXPECT_NEAR(renderer_->fieldRange().high, 0.1, 1e-6) << "a round number";
    EXPECT_NEAR(renderer_->fieldRange().low, 0.05, 1e-6) << "of the narrow sides";
    show(stage, SurfaceField::area);
    EXPECT_NEAR(at(middleOfFront(slab)), 1.1 * 0.95 - 1, 1e-5);
    EXPECT_NEAR(renderer_->fieldRange().low, -renderer_->fieldRange().high, 1e-9);
}

TEST_F(FieldTest, ASqueezeCountsAsStrainAndAsLossOfArea) {
    const SurfaceMesh slab = test::box(Vec3(1, 1, 0.2), 4);
    Stage stage(moved(slab, [](const Vec3& p) { return Vec3(0.7 * p.x(), 1.1 * p.y(), p.z()); }));
    show(stage, SurfaceField::strain);
    EXPECT_NEAR(at(middleOfFront(slab)), 0.3, 1e-5);
    show(stage, SurfaceField::area);
    EXPECT_NEAR(at(middleOfFront(slab)), 0.77 - 1, 1e-5);
}

TEST_F(FieldTest, AShearHasItsPrincipalStrain) {
    const SurfaceMesh slab = test::box(Vec3(1, 1, 0.2), 4);
    const double g = 0.3;
    Stage stage(moved(slab, [g](const Vec3& p) { return Vec3(p.x() + g * p.y(), p.y(), p.z()); }));
    show(stage, SurfaceField::strain);
    const double larger = std::sqrt(1 + g * g / 2 + g * std::sqrt(1 + g * g / 4));
    EXPECT_NEAR(at(middleOfFront(slab)), larger - 1, 1e-5);
    show(stage, SurfaceField::area);
    EXPECT_NEAR(at(middleOfFront(slab)), 0, 1e-5);
}

TEST_F(FieldTest, ATurnedBodyHasNoStrain) {
    const SurfaceMesh ball = test::cubeSphere(8);
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(1.2, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    Stage stage(moved(ball, [&](const Vec3& p) { return Vec3(turn * p + Vec3(3, 2, 1)); }));
    show(stage, SurfaceField::strain);
    for (int v = 0; v < ball.vertexCount(); ++v) {
        EXPECT_NEAR(at(v), 0, 1e-5);
    }
    EXPECT_NEAR(renderer_->fieldRange().high, 0.01, 1e-6) << "noise fills no range";
}

TEST_F(FieldTest, AFaceTowardsTheEyeHasTheColourOfTheLegend) {
    const SurfaceMesh slab = test::box(Vec3(1, 1, 0.2), 4);
    Stage stage(moved(slab, [](const Vec3& p) { return Vec3(1.1 * p.x(), p.y(), p.z()); }));
    stage.camera.orthographic = true;
    stage.camera.eye = Vec3(0, 0, 3);
    stage.camera.target = Vec3::Zero();
    const Image top = show(stage, SurfaceField::strain);
    const std::size_t middle = std::size_t(4) * (kHeight / 2 * kWidth + kWidth / 2);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(top.pixels[middle + c], kViridis.back()[c], 4) << c;
    }
    stage.scene.field.choice.range = FieldRange{-0.1F, 0.3F};
    const Image half = stage.picture(*renderer_);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(half.pixels[middle + c], kViridis[5][c], 4) << c;
    }
    stage.scene.field.choice.map = ColorMapName::inferno;
    const Image inferno = stage.picture(*renderer_);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(inferno.pixels[middle + c], kInferno[5][c], 4) << c;
    }
}

/// As at the rim of a cut.
TEST_F(FieldTest, AFewSpikesDoNotStretchTheRange) {
    const SurfaceMesh ball = test::cubeSphere(16);
    SurfaceMesh spiky = moved(ball, [](const Vec3& p) { return Vec3(1.05 * p); });
    spiky.setPosition(0, 4 * spiky.position(0));
    Stage stage(spiky);
    show(stage, SurfaceField::strain);
    EXPECT_GT(at(0), 1);
    EXPECT_LT(renderer_->fieldRange().high, 0.1);
    EXPECT_NEAR(renderer_->fieldRange().low, 0.05, 0.005);
}

TEST(AutomaticRange, CountsTheSurfaceAndNotTheVertices) {
    std::vector<FieldSample> samples(1000, {5, 1e-6F});  // slivers
    samples.insert(samples.end(), 10, {0.2F, 1});
    samples.insert(samples.end(), 10, {0.4F, 1});
    const FieldRange range = automaticRange(samples, infoOf(SurfaceField::strain));
    EXPECT_NEAR(range.low, 0.2, 1e-6);
    EXPECT_NEAR(range.high, 0.4, 1e-6);
}

TEST(AutomaticRange, ReachesAsFarBelowZeroWithASign) {
    const FieldRange range = automaticRange({{-0.31F, 1}, {0.1F, 1}}, infoOf(SurfaceField::area));
    EXPECT_NEAR(range.low, -0.4, 1e-6);
    EXPECT_EQ(range.high, -range.low);
}

TEST(AutomaticRange, OfNothingIsTheLeast) {
    const FieldRange range = automaticRange({}, infoOf(SurfaceField::strain));
    EXPECT_EQ(range.low, 0);
    EXPECT_NEAR(range.high, 0.01, 1e-9);
}

TEST_F(FieldTest, WallsHaveValuesOfTheirOwn) {
    const SurfaceMesh opened = test::openedSphere(8, 0.05, 0.25);
    Stage stage(opened);
    show(stage, SurfaceField::strain);
    int onWalls = 0;
    for (int v = 0; v < opened.vertexCount(); ++v) {
        onWalls += at(v, true) >= 0 ? 1 : 0;
    }
    EXPECT_GT(onWalls, 0);
    EXPECT_LT(onWalls, opened.vertexCount());
}

TEST_F(FieldTest, AnotherRevisionHasNoValueYet) {
    Stage stage(test::cubeSphere(4));
    show(stage, SurfaceField::strain);
    EXPECT_TRUE(renderer_->fieldAt(1, 0, false));
    EXPECT_FALSE(renderer_->fieldAt(2, 0, false));
}

}  // namespace
}  // namespace kerf::render

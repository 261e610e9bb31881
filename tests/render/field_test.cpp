// Quantities as colours on the surface: their numbers against what analysis says.
#include "render/renderer.h"
#include "render/scene/depth_field.h"
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
    const SurfaceMesh slab = box(Vec3(1, 1, 0.2), 4);
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
    const SurfaceMesh slab = box(Vec3(1, 1, 0.2), 4);
    Stage stage(moved(slab, [](const Vec3& p) { return Vec3(0.7 * p.x(), 1.1 * p.y(), p.z()); }));
    show(stage, SurfaceField::strain);
    EXPECT_NEAR(at(middleOfFront(slab)), 0.3, 1e-5);
    show(stage, SurfaceField::area);
    EXPECT_NEAR(at(middleOfFront(slab)), 0.77 - 1, 1e-5);
}

TEST_F(FieldTest, AShearHasItsPrincipalStrain) {
    const SurfaceMesh slab = box(Vec3(1, 1, 0.2), 4);
    const double g = 0.3;
    Stage stage(moved(slab, [g](const Vec3& p) { return Vec3(p.x() + g * p.y(), p.y(), p.z()); }));
    show(stage, SurfaceField::strain);
    const double larger = std::sqrt(1 + g * g / 2 + g * std::sqrt(1 + g * g / 4));
    EXPECT_NEAR(at(middleOfFront(slab)), larger - 1, 1e-5);
    show(stage, SurfaceField::area);
    EXPECT_NEAR(at(middleOfFront(slab)), 0, 1e-5);
}

TEST_F(FieldTest, ATurnedBodyHasNoStrain) {
    const SurfaceMesh ball = cubeSphere(8);
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
    const SurfaceMesh slab = box(Vec3(1, 1, 0.2), 4);
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
    const SurfaceMesh ball = cubeSphere(16);
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
    const SurfaceMesh opened = openedSphere(8, 0.05, 0.25);
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
    Stage stage(cubeSphere(4));
    show(stage, SurfaceField::strain);
    EXPECT_TRUE(renderer_->fieldAt(1, 0, false));
    EXPECT_FALSE(renderer_->fieldAt(2, 0, false));
}

/// Largest difference between the field and `expected(point)` [m].
template <class F>
double worstError(const DepthField& field, F&& expected) {
    double worst = 0;
    for (int z = 0; z < field.size[2]; ++z) {
        for (int y = 0; y < field.size[1]; ++y) {
            for (int x = 0; x < field.size[0]; ++x) {
                const Vec3 point = field.origin + field.spacing * Vec3(x, y, z);
                const double depth = field.deepest * field.values[field.index(x, y, z)];
                worst = std::max(worst, std::abs(depth - expected(point)));
            }
        }
    }
    return worst;
}

double sampled(const DepthField& field, const Vec3& sample) {
    const Vec3 i = ((sample - field.origin) / field.spacing).array().round();
    return field.deepest * field.values[field.index(int(i.x()), int(i.y()), int(i.z()))];
}

TEST(DepthField, OfASphereIsTheDistanceToItsSurface) {
    const double radius = 0.5;
    const DepthField field = measureDepth(icosphere(4, radius), 32);
    const auto depth = [&](const Vec3& p) { return radius - p.norm(); };
    const auto nearDepth = [&](const Vec3& p) {
        return std::abs(depth(p)) < field.spacing ? depth(p) : sampled(field, p);
    };
    // Where triangles were measured themselves: the mesh lies up to 0.0006 m inside the sphere.
    EXPECT_LT(worstError(field, nearDepth), 0.001);
    // Elsewhere a neighbour's triangle may not be the very nearest.
    EXPECT_LT(worstError(field, depth), 0.02 * radius);
    EXPECT_NEAR(field.deepest, radius, field.spacing);
}

TEST(DepthField, OfABoxHasEdgesAndCorners) {
    const Vec3 half(0.5, 0.3, 0.2);
    const DepthField field = measureDepth(box(2 * half, 3), 32);
    const auto depth = [&](const Vec3& p) {
        const Vec3 q = p.cwiseAbs() - half;
        return q.maxCoeff() <= 0 ? -q.maxCoeff() : -Vec3(q.cwiseMax(0)).norm();
    };
    EXPECT_LT(worstError(field, depth), 1e-6);
}

TEST(DepthField, OfATorusIsNegativeInItsHole) {
    const DepthField field = measureDepth(torus(), 32);
    const Vec3 middle = (-field.origin / field.spacing).array().round();
    const int center = field.index(int(middle.x()), int(middle.y()), int(middle.z()));
    EXPECT_LT(field.values[center], 0);
}

TEST(DepthField, ValuesReachOne) {
    const DepthField field = measureDepth(bentTube(), 24);
    EXPECT_FLOAT_EQ(*std::max_element(field.values.begin(), field.values.end()), 1);
}

// A plane that opens the picture of a body: what is hidden, and what is filled.

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
    Stage stage(box(Vec3(1, 1, 1), 2));
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
    Stage stage(icosphere(4, 0.5));
    stage.scene.field.choice.field = SurfaceField::strain;
    const Image image = lookAt(stage, {Vec3(0, 0, 0.3), Vec3::UnitZ()});
    EXPECT_NEAR(areaOf(greyPixels(image)), std::numbers::pi * 0.16, 0.01);
}

TEST_F(SectionTest, OfARingLeavesItsHoleOpen) {
    Stage stage(torus(64, 32, 0.35, 0.15));
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
    Stage stage(box(Vec3(1, 1, 1), 2));
    const Image all = lookAt(stage, {Vec3(0, 0, 0.6), Vec3::UnitZ()});
    EXPECT_NEAR(areaOf(covered(all)), 1, 0.02);
    const Image none = lookAt(stage, {Vec3(0, 0, -0.6), Vec3::UnitZ()});
    EXPECT_EQ(covered(none), 0);
}

TEST_F(SectionTest, BothHalvesOfACutBodyAreFilled) {
    Stage stage(openedSphere(10, 0.2, 0));
    stage.scene.field.choice.field = SurfaceField::strain;
    const Image image = lookAt(stage, {Vec3::Zero(), Vec3::UnitX()});
    // Two half discs of radius 1, of which the picture shows what is less than 1 from its middle.
    EXPECT_GT(areaOf(covered(image)), 2.5);
    EXPECT_EQ(image.pixels[byteAt(0, 0) + 3], 0) << "the gap between them is open";
}

TEST_F(SectionTest, WithoutOneThePictureIsThatOfBefore) {
    Stage stage(openedSphere(8, 0.05, 0.25));
    stage.scene.bodyRevision = 1;
    const Image before = stage.picture(*renderer_);
    stage.scene.section = SectionPlane{};
    EXPECT_NE(stage.picture(*renderer_).pixels, before.pixels);
    stage.scene.section.reset();
    EXPECT_EQ(stage.picture(*renderer_).pixels, before.pixels);
}

}  // namespace
}  // namespace kerf::render

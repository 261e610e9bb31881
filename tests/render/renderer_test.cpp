#include "render/renderer.h"

#include "gpu/context.h"
#include "render/passes/normals_pass.h"
#include "render/scene/picture_comparison.h"
#include "shaders/shared/shared_types.h"
#include "sim/body/body_updater.h"
#include "sim/cut/stroke/cutter.h"
#include "sim/mesh/invariants.h"
#include "tests/render/stage.h"
#include "tests/support/body_upload.h"
#include "tests/support/shapes.h"
#include "tests/support/written_png.h"

namespace kerf::render {
namespace {

const std::uint8_t* pixelAt(const Image& image, int x, int y) {
    return &image.pixels[std::size_t(4) * (std::size_t(y) * image.width + x)];
}

bool isReddish(const std::uint8_t* pixel) {
    return pixel[0] > pixel[2] + 40;
}

long countReddish(const Image& image) {
    long count = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
        count += isReddish(&image.pixels[i]) ? 1 : 0;
    }
    return count;
}

class RendererTest : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        light_ = std::make_unique<Renderer>(Quality::light);
    }
    Image pictureOf(const Stage& stage) { return stage.picture(*light_); }

    std::unique_ptr<Renderer> light_;
};

TEST_F(RendererTest, DrawsTheBodyWhereItIs) {
    const Image picture = pictureOf(Stage(cubeSphere(8)));
    ASSERT_EQ(picture.width, kWidth);
    ASSERT_EQ(picture.height, kHeight);
    EXPECT_TRUE(isReddish(pixelAt(picture, kWidth / 2, kHeight / 2)));
    EXPECT_FALSE(isReddish(pixelAt(picture, 2, kHeight / 2)));
    // A sphere of radius 0.5 framed by its box: about a fifth of the picture.
    const double share = double(countReddish(picture)) / (kWidth * kHeight);
    EXPECT_GT(share, 0.12);
    EXPECT_LT(share, 0.35);
}

TEST_F(RendererTest, TopRowIsTheTopOfTheScene) {
    Stage stage(cubeSphere(8));
    stage.scene.floor.reset();
    stage.camera.eye += Vec3(0, 0.3, 0);
    stage.camera.target += Vec3(0, 0.3, 0);
    const Image picture = pictureOf(stage);
    EXPECT_TRUE(isReddish(pixelAt(picture, kWidth / 2, kHeight - 20)));
    EXPECT_FALSE(isReddish(pixelAt(picture, kWidth / 2, 10)));
}

TEST_F(RendererTest, AViewThatTurnsAroundABodyAtRestIsThatOfANewRenderer) {
    Stage stage(openedSphere(10, 0.05, 0.25));
    stage.scene.bodyRevision = 1;
    pictureOf(stage);
    stage.camera.eye = Vec3(-1.2, 0.9, 1.4);
    Renderer fresh(Quality::light);
    EXPECT_EQ(pictureOf(stage).pixels, stage.picture(fresh).pixels);
}

TEST_F(RendererTest, ShadowsFollowABodyOfAnotherRevisionAndWhatStandsBesideIt) {
    Stage low(cubeSphere(8));
    low.scene.bodyRevision = 1;
    pictureOf(low);
    Stage other(openedSphere(10, 0.05, 0.25));
    other.scene.bodyRevision = 2;
    Renderer fresh(Quality::light);
    EXPECT_EQ(pictureOf(other).pixels, other.picture(fresh).pixels);
    other.scene.boxes.push_back({Vec3(0.5, 0.2, 0), Vec3(0.3, 0.3, 0.3), Vec3::Zero()});
    Renderer again(Quality::light);
    EXPECT_EQ(pictureOf(other).pixels, other.picture(again).pixels);
}

TEST_F(RendererTest, PictureIsOpaqueAndFreeOfBlackHoles) {
    const Image picture = pictureOf(Stage(openedSphere(10, 0.05, 0.25)));
    for (std::size_t i = 0; i < picture.pixels.size(); i += 4) {
        ASSERT_EQ(picture.pixels[i + 3], 255);
        ASSERT_GT(picture.pixels[i] + picture.pixels[i + 1] + picture.pixels[i + 2], 6);
    }
}

TEST_F(RendererTest, TheSameSceneGivesTheSameBytes) {
    Stage stage(openedSphere(8, 0.05, 0.25));
    stage.scene.blade = Blade{Vec3(-1, 0.5, 0), Vec3(1, 0.5, 0)};
    stage.scene.strokePoses = {{Vec3(-1, 1.2, 0), Vec3(1, 1.2, 0)}, *stage.scene.blade};
    const Image first = pictureOf(stage);
    // Another size, another scene and a foreign state in between must not matter.
    light_->draw(SceneView{}, Camera{}, 64, 64);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 3, 3);
    glEnable(GL_CULL_FACE);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    EXPECT_EQ(pictureOf(stage).pixels, first.pixels);
    Renderer other(Quality::light);
    EXPECT_EQ(stage.picture(other).pixels, first.pixels);
}

TEST_F(RendererTest, FullQualityIsTheSamePictureButSmoother) {
    const Stage stage(cubeSphere(8));
    Renderer full(Quality::full);
    const PictureComparison comparison = comparePictures(pictureOf(stage), stage.picture(full));
    EXPECT_TRUE(withinLimits(comparison, kTolerantLimits))
        << comparison.worst << ", " << comparison.shareDiffering();
    EXPECT_FALSE(comparison.identical);
}

TEST_F(RendererTest, EmptySceneDrawsFloorAndBackdrop) {
    SceneView scene;
    scene.floor = -0.5;
    light_->draw(scene, Camera{}, kWidth, kHeight);
    const Image picture = light_->readPicture();
    EXPECT_LT(countReddish(picture), kWidth * kHeight / 20);
    EXPECT_GT(pixelAt(picture, kWidth / 2, kHeight - 5)[2], 30);
}

TEST_F(RendererTest, WallsLookUnlikeSkin) {
    Stage stage(openedSphere(12, 0.05, 0.5));
    stage.camera.eye = Vec3(4, 1.5, 0.8);
    stage.camera.frame(stage.body.bounds);
    const Image cut = pictureOf(stage);
    long pale = 0;
    for (std::size_t i = 0; i < cut.pixels.size(); i += 4) {
        const std::uint8_t* pixel = &cut.pixels[i];
        pale += pixel[1] > 120 && pixel[1] > pixel[2] + 20 ? 1 : 0;
    }
    EXPECT_GT(pale, 200);
}

/// A mesh cut in two by a blade that comes down, a little askew, and what BodyModel knows of it.
struct CutBody {
    explicit CutBody(const SurfaceMesh& whole) : mesh(whole) {
        BodyUpdater updater(mesh);
        CutSettings settings;
        settings.wallEdgeLength = 0.1;
        Cutter cutter(mesh, settings);
        const auto bladeAt = [](double y) { return Blade{{0.03, y, -1}, {0.12, y - 0.05, 1}}; };
        cutter.begin(bladeAt(1));
        for (int step = 1; step <= 20; ++step) {
            cutter.boundMotion(0);
            const CutResult result = cutter.advance(bladeAt(1 - 0.1 * step));
            if (!result.delta.empty()) {
                updater.update(result.delta);
            }
        }
        cutter.boundMotion(0);
        if (const CutDelta delta = cutter.finish().delta; !delta.empty()) {
            updater.update(delta);
        }
        for (const Vec3f& n : updater.model().cutSkinNormals) {
            normals.push_back(n.cast<double>());
        }
    }
    SurfaceMesh mesh;
    std::vector<Vec3> normals;
};

int largestDifference(const Image& a, const Image& b) {
    int largest = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        largest = std::max(largest, std::abs(int(a.pixels[i]) - int(b.pixels[i])));
    }
    return largest;
}

TEST_F(RendererTest, ACutThatIsClosedDoesNotShowOnTheSkin) {
    const SurfaceMesh whole = cubeSphere(8);
    const CutBody cut(whole);
    ASSERT_EQ(findPieces(cut.mesh).pieces.size(), 2u);
    const Stage before(whole);
    Stage after(cut.mesh, cut.normals);
    Stage bare(cut.mesh);
    after.camera = bare.camera = before.camera;
    const Image picture = pictureOf(before);
    EXPECT_LT(largestDifference(pictureOf(after), picture), 16) << "of 255";
    EXPECT_GT(largestDifference(pictureOf(bare), picture), 24) << "what the normals are for";
}

TEST_F(RendererTest, ALineShowsAClosedCutWhereThatIsWanted) {
    const SurfaceMesh whole = cubeSphere(8);
    const CutBody cut(whole);
    Stage stage(cut.mesh, cut.normals);
    stage.camera.eye = Vec3(0, 0, 4);  // onto the cut's rim, which runs from top to bottom
    stage.camera.target = Vec3::Zero();
    const Image plain = pictureOf(stage);
    stage.scene.cutLines = true;
    const Image lined = pictureOf(stage);
    int rows = 0;
    int most = 0;
    for (int y = 0; y < kHeight; ++y) {
        int dark = 0;
        for (int x = 0; x < kWidth; ++x) {
            dark += pixelAt(lined, x, y)[0] < pixelAt(plain, x, y)[0] - 40 ? 1 : 0;
        }
        rows += dark > 0 ? 1 : 0;
        most = std::max(most, dark);
    }
    EXPECT_GT(rows, kHeight / 4) << "all along the cut";
    EXPECT_LE(most, 6) << "and thin";
    Stage uncut(whole);
    uncut.camera = stage.camera;
    const Image before = pictureOf(uncut);
    uncut.scene.cutLines = true;
    EXPECT_EQ(largestDifference(pictureOf(uncut), before), 0) << "none without a cut";
}

/// The same body, so many times as large.
SurfaceMesh scaled(SurfaceMesh mesh, double factor) {
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        mesh.setPosition(v, factor * mesh.position(v));
        mesh.setRestPosition(v, factor * mesh.restPosition(v));
    }
    return mesh;
}

/// With the lines of its cut, its triangles, the edges of the solver, a box and a blade.
Stage stageOfSize(const CutBody& cut, double size) {
    Stage stage(scaled(cut.mesh, size), cut.normals);
    stage.camera.eye = size * Vec3(1, 1, 4);
    stage.camera.target = Vec3::Zero();
    stage.camera.frame(stage.body.bounds);
    stage.scene.cutLines = true;
    stage.scene.wireframe = true;
    stage.scene.overlays.edges = true;
    stage.scene.overlays.boxes = true;
    stage.scene.pieceBoxes = {stage.body.bounds};
    stage.scene.blade = Blade{size * Vec3(-0.7, 0.55, 0), size * Vec3(0.7, 0.55, 0)};
    stage.scene.strokePoses = {{size * Vec3(-0.7, 0.8, 0), size * Vec3(0.7, 0.8, 0)},
                               *stage.scene.blade};
    return stage;
}

TEST_F(RendererTest, LinesAndBladeAreTheSameAtEverySize) {
    const CutBody cut(cubeSphere(8));
    const Image usual = pictureOf(stageOfSize(cut, 1));
    for (const double size : {1e-6, 2e-6, 1e-4, 1e-2, 1e2, 1e3}) {
        EXPECT_LT(channelDifference(pictureOf(stageOfSize(cut, size)), usual).pixels,
                  kWidth * kHeight / 100)
            << size << " m";
    }
}

/// Seen along its edge, a blade has two sides that catch the light differently.
TEST_F(RendererTest, ABladeAlongTheLineOfSightShowsItsSides) {
    Stage stage(cubeSphere(4));
    stage.scene.body = BodyView{};
    stage.scene.floor.reset();
    stage.camera.eye = Vec3(0, 0, 3);
    stage.camera.target = Vec3::Zero();
    const Image bare = pictureOf(stage);
    stage.scene.blade = Blade{Vec3(0, 0, 1), Vec3(0, 0, -1)};
    stage.scene.strokePoses = {Blade{Vec3(-0.5, 0, 1), Vec3(-0.5, 0, -1)}, *stage.scene.blade};
    const Image blade = pictureOf(stage);
    const auto bright = [&](int x, int y) { return int(pixelAt(blade, x, y)[1]); };
    const int column = kWidth / 2 - 8;  // behind the edge, which is in the middle
    int above = 0;
    int below = 0;
    for (int y = 1; y < kHeight / 2; ++y) {
        above += pixelAt(bare, column, kHeight / 2 - y)[1] != bright(column, kHeight / 2 - y);
        below += pixelAt(bare, column, kHeight / 2 + y)[1] != bright(column, kHeight / 2 + y);
    }
    EXPECT_GT(above, 0);
    EXPECT_GT(below, 0);
    EXPECT_NE(bright(column, kHeight / 2 - 1), bright(column, kHeight / 2 + 1));
}

TEST_F(RendererTest, APieceIsDrawnWhereItsShiftSays) {
    Stage stage(cubeSphere(8));
    stage.scene.floor.reset();
    const Image before = pictureOf(stage);
    stage.scene.pieces = {{.shift = Vec3(0, 100, 0)}};
    EXPECT_GT(countReddish(before), 100);
    EXPECT_EQ(countReddish(pictureOf(stage)), 0) << "out of the picture";
}

TEST_F(RendererTest, BodyDarkensTheFloorBelow) {
    Stage stage(cubeSphere(8));
    stage.camera.eye = Vec3(0, 1.2, 3);
    stage.camera.frame(stage.body.bounds);
    const Image with = pictureOf(stage);
    stage.scene.body = BodyView{};
    const Image without = pictureOf(stage);
    long darker = 0;
    for (std::size_t i = 0; i < with.pixels.size(); i += 4) {
        darker += with.pixels[i + 2] + 8 < without.pixels[i + 2] ? 1 : 0;
    }
    EXPECT_GT(darker, 300);
}

TEST_F(RendererTest, BladeAndSweepAreDrawn) {
    Stage stage(cubeSphere(8));
    const Image bare = pictureOf(stage);
    stage.scene.blade = Blade{Vec3(-0.7, 0.55, 0), Vec3(0.7, 0.55, 0)};
    const Image blade = pictureOf(stage);
    EXPECT_GT(channelDifference(bare, blade).pixels, 100);
    stage.scene.strokePoses = {{Vec3(-0.7, 0.8, 0), Vec3(0.7, 0.8, 0)}, *stage.scene.blade};
    EXPECT_GT(channelDifference(blade, pictureOf(stage)).pixels, 300);
}

TEST_F(RendererTest, BoxesAreDrawnAndShadowed) {
    Stage stage(cubeSphere(8));
    stage.camera.eye = Vec3(0, 3, 0.5);
    const Image bare = pictureOf(stage);
    stage.scene.boxes = {StaticBox{{0, -0.45, 0}, {1.6, 0.1, 1.6}, {0, 30, 0}}};
    const Image lit = pictureOf(stage);
    EXPECT_GT(channelDifference(bare, lit).pixels, 2000);
    // The sphere stands on the box and darkens it; without a body there is no shadow.
    stage.scene.body = BodyView{};
    const Image alone = pictureOf(stage);
    long darker = 0;
    for (std::size_t i = 0; i < lit.pixels.size(); i += 4) {
        darker += !isReddish(&lit.pixels[i]) && lit.pixels[i + 2] + 30 < alone.pixels[i + 2];
    }
    EXPECT_GT(darker, 300);
}

TEST_F(RendererTest, WhatPanelsCoverIsLeftOutAndTheRestIsTheSame) {
    Stage stage(cubeSphere(8));
    const Image all = pictureOf(stage);
    stage.scene.covered = {{10, 20, kWidth / 2, kHeight / 2}};
    const Image open = pictureOf(stage);
    const auto isCovered = [](int x, int y, int margin) {
        return x >= 10 - margin && x < 10 + kWidth / 2 + margin && y >= 20 - margin &&
               y < 20 + kHeight / 2 + margin;
    };
    constexpr int kSmoothed = 6;  // edges are smoothed over so many pixels
    int reddish = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            if (isCovered(x, y, -kSmoothed)) {
                reddish += isReddish(pixelAt(open, x, y)) ? 1 : 0;
            } else if (!isCovered(x, y, kSmoothed)) {
                ASSERT_TRUE(
                    std::equal(pixelAt(all, x, y), pixelAt(all, x, y) + 4, pixelAt(open, x, y)))
                    << x << ", " << y;
            }
        }
    }
    EXPECT_EQ(reddish, 0);
}

TEST_F(RendererTest, DegenerateBladeAndCameraAreHarmless) {
    Stage stage(cubeSphere(4));
    stage.scene.blade = Blade{Vec3(0, 1, 0), Vec3(0, 1, 0)};
    stage.scene.strokePoses = {*stage.scene.blade, *stage.scene.blade};
    stage.camera.eye = Vec3(0, 3, 0);
    EXPECT_GT(countReddish(pictureOf(stage)), 100);
    stage.scene.blade = Blade{Vec3(0, -9, 0), Vec3(0, 9, 0)};
    EXPECT_GT(countReddish(pictureOf(stage)), 100);
}

TEST_F(RendererTest, WireframeShowsEdges) {
    Stage stage(cubeSphere(8));
    const Image plain = pictureOf(stage);
    stage.scene.wireframe = true;
    EXPECT_GT(channelDifference(plain, pictureOf(stage)).pixels, 1000);
}

/// A cube of twelve triangles, of one even colour, from where three faces are seen.
Stage cubeStage() {
    Stage stage(box(Vec3::Ones(), 1));
    stage.scene.look = rowOf(LookName::grey).look;
    stage.scene.floor.reset();
    stage.camera.eye = Vec3(2, 1.5, 3);
    stage.camera.frame(stage.body.bounds);
    return stage;
}

/// Where a point of the scene is drawn.
std::array<int, 2> pixelOf(const Stage& stage, const Vec3& point) {
    const Eigen::Vector4f clip = stage.camera.projection(double(kWidth) / kHeight) *
                                 stage.camera.view() * Vec3f(point.cast<float>()).homogeneous();
    return {int((0.5F + 0.5F * clip.x() / clip.w()) * kWidth),
            int((0.5F - 0.5F * clip.y() / clip.w()) * kHeight)};
}

int greenAt(const Image& picture, const Stage& stage, const Vec3& point) {
    const auto [x, y] = pixelOf(stage, point);
    return pixelAt(picture, x, y)[1];
}

/// How much the front face of the cube differs from its middle towards its edges, at most.
int unevenness(const Image& picture, const Stage& stage) {
    const int middle = greenAt(picture, stage, {0, 0, 0.5});
    int most = 0;
    for (const double x : {-0.4, -0.2, 0.0, 0.2, 0.4}) {
        for (const double y : {-0.4, -0.2, 0.0, 0.2, 0.4}) {
            most = std::max(most, std::abs(greenAt(picture, stage, {x, y, 0.5}) - middle));
        }
    }
    return most;
}

TEST_F(RendererTest, ACubeOfTwelveTrianglesHasFlatFacesAndHardEdges) {
    Stage stage = cubeStage();
    const Image hard = pictureOf(stage);
    EXPECT_LT(unevenness(hard, stage), 12);
    EXPECT_GT(std::abs(greenAt(hard, stage, {0, 0.45, 0.5}) - greenAt(hard, stage, {0, 0.5, 0.45})),
              15)
        << "top and front on either side of their edge";
    stage.scene.hardEdges = 180;
    EXPECT_GT(unevenness(pictureOf(stage), stage), 30) << "what hard edges are for";
}

/// The cube with a face whose triangles meet in two of its corners, many in each: a cut leaves
/// such.
SurfaceMesh cubeWithFans() {
    constexpr int kBlades = 24;
    TriangleSoup soup = boxSoup();
    const auto isFront = [&](const Triangle& t) {
        return std::ranges::all_of(t, [&](int v) { return soup.positions[v].z() > 0; });
    };
    std::erase_if(soup.triangles, isFront);
    const auto cornerAt = [&](double x, double y) {
        return static_cast<int>(std::ranges::find(soup.positions, Vec3(x, y, 0.5)) -
                                soup.positions.begin());
    };
    std::vector<int> line{cornerAt(0.5, -0.5)};
    for (int i = 1; i < kBlades; ++i) {
        line.push_back(static_cast<int>(soup.positions.size()));
        soup.positions.emplace_back(0.5 - double(i) / kBlades, double(i) / kBlades - 0.5, 0.5);
    }
    line.push_back(cornerAt(-0.5, 0.5));
    for (int i = 0; i < kBlades; ++i) {
        soup.triangles.push_back({cornerAt(0.5, 0.5), line[i + 1], line[i]});
        soup.triangles.push_back({cornerAt(-0.5, -0.5), line[i], line[i + 1]});
    }
    return meshOf(soup);
}

TEST_F(RendererTest, CornersOfManyTrianglesHaveHardEdges) {
    Stage stage(cubeWithFans());
    const Stage plain = cubeStage();
    stage.scene.look = plain.scene.look;
    stage.scene.floor.reset();
    stage.camera = plain.camera;
    EXPECT_LT(unevenness(pictureOf(stage), stage), 12);
}

TEST_F(RendererTest, ACutThroughACubeLeavesItsFacesFlat) {
    const SurfaceMesh whole = box(Vec3::Ones(), 1);
    const CutBody cut(whole);
    Stage stage = cubeStage();
    Stage after(cut.mesh, cut.normals);
    after.scene.look = stage.scene.look;
    after.scene.floor.reset();
    after.camera = stage.camera;
    const Image before = pictureOf(stage);
    EXPECT_LT(largestDifference(pictureOf(after), before), 16) << "of 255";
}

TEST_F(RendererTest, ACoarseBallHasARoundOutline) {
    Stage stage(icosphere(1));
    stage.scene.floor.reset();
    stage.camera.eye = Vec3(0, 0, 3);
    stage.camera.target = Vec3::Zero();
    Renderer full(Quality::full);
    const Image picture = stage.picture(full);
    const auto radiusTowards = [&](double angle) {
        int radius = kHeight / 2 - 2;
        const auto at = [&](int r) {
            return pixelAt(picture, kWidth / 2 + int(std::lround(r * std::cos(angle))),
                           kHeight / 2 - int(std::lround(r * std::sin(angle))));
        };
        while (radius > 0 && !isReddish(at(radius))) {
            --radius;
        }
        return radius;
    };
    int low = kHeight;
    int high = 0;
    for (int i = 0; i < 72; ++i) {
        const int radius = radiusTowards(i * 2 * 3.14159265 / 72);
        low = std::min(low, radius);
        high = std::max(high, radius);
    }
    EXPECT_GT(low, 20);
    EXPECT_GE(low, 0.955 * high - 1) << "with straight sides it is less than 0.95";
}

TEST_F(RendererTest, EachLookIsAnotherPicture) {
    Stage stage(openedSphere(12, 0.05, 0.5));
    stage.camera.eye = Vec3(4, 1.5, 0.8);
    stage.camera.frame(stage.body.bounds);
    std::vector<Image> pictures;
    for (std::size_t i = 0; i < kLookNames; ++i) {
        stage.scene.look = rowOf(static_cast<LookName>(i)).look;
        const Image picture = pictureOf(stage);
        for (const Image& other : pictures) {
            EXPECT_GT(largestDifference(picture, other), 40) << kLookWords[i];
        }
        pictures.push_back(picture);
    }
}

/// Normals from the definition, in double precision: angle-weighted, slivers less, one kind of
/// triangle only.
Vec3 referenceNormal(const SurfaceMesh& mesh, int vertex, SurfaceKind kind) {
    Vec3 sum = Vec3::Zero();
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        for (int c = 0; c < 3 && mesh.alive(t) && mesh.kind(t) == kind; ++c) {
            if (mesh.triangle(t)[c] == vertex) {
                const Vec3& p = mesh.position(vertex);
                const Vec3 u = mesh.position(mesh.triangle(t)[(c + 1) % 3]) - p;
                const Vec3 v = mesh.position(mesh.triangle(t)[(c + 2) % 3]) - p;
                const Vec3 n = u.cross(v);
                const double longest =
                    std::max({u.squaredNorm(), v.squaredNorm(), (u - v).squaredNorm()});
                const double shape = std::min(1.0, n.norm() / (0.2 * longest));
                sum += n.normalized() * shape * std::atan2(n.norm(), u.dot(v));
            }
        }
    }
    return sum;
}

TEST_F(RendererTest, NormalsAgreeWithTheDefinition) {
    const SurfaceMesh mesh = openedSphere(6, 0.1, 0.3);
    const UploadedBody body(mesh);
    NormalsPass pass;
    pass.run(body.view(), kHardEdgeAngle, false);
    const auto normals = pass.normals().read<shared::vec4>(0, 2 * body.vertexCount);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        for (const SurfaceKind kind : {SurfaceKind::skin, SurfaceKind::wall}) {
            const Vec3 expected = referenceNormal(mesh, v, kind);
            const shared::vec4& n = normals[std::size_t(2 * v) + std::size_t(kind)];
            if (expected.norm() > 0) {
                EXPECT_LT((Vec3(n.x, n.y, n.z) - expected.normalized()).norm(), 2e-5) << v;
            }
        }
    }
}

/// Compares with tests/golden/NAME.png; with KERF_UPDATE_GOLDEN=1 writes it instead.
void expectGolden(const Image& picture, const std::string& name) {
    const fs::path file = fs::path(KERF_SOURCE_DIR) / "tests/golden" / (name + ".png");
    if (std::getenv("KERF_UPDATE_GOLDEN") != nullptr) {
        writePng(picture, file);
        return;
    }
    const Image golden = readPng(file);
    const PictureComparison comparison = comparePictures(golden, picture);
    if (withinLimits(comparison, kStrictLimits)) {
        return;
    }
    const fs::path folder = KERF_BINARY_DIR;
    writePng(picture, folder / (name + "-now.png"));
    if (comparison.sameSize) {
        writePng(differencePicture(golden, comparison), folder / (name + "-difference.png"));
    }
    FAIL() << name << ": the worst place differs by " << comparison.worst << ", "
           << 100 * comparison.shareDiffering() << " % of the pixels do; see " << folder;
}

TEST_F(RendererTest, GoldenSphereUnderTheBlade) {
    Stage stage(cubeSphere(8));
    stage.scene.blade = Blade{Vec3(-0.7, 0.3, 0), Vec3(0.7, 0.3, 0)};
    stage.scene.strokePoses = {{Vec3(-0.7, 0.8, 0), Vec3(0.7, 0.8, 0)}, *stage.scene.blade};
    expectGolden(pictureOf(stage), "sphere-under-the-blade");
}

TEST_F(RendererTest, GoldenOpenedSphere) {
    Stage stage(openedSphere(16, 0.05, 0.4));
    stage.camera.eye = Vec3(4, 1.5, 1.4);
    stage.camera.frame(stage.body.bounds);
    light_->setRestShape(cubeSphere(12, 1.0));
    expectGolden(pictureOf(stage), "opened-sphere");
}

}  // namespace
}  // namespace kerf::render

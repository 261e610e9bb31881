#include "render/scene/picture_comparison.h"

#include <ostream>

#include "tests/render/light_renderer_test.h"
#include "tests/render/stage.h"
#include "tests/support/shapes.h"

namespace kerf::render {

/// For messages of tests.
std::ostream& operator<<(std::ostream& out, const PictureComparison& comparison) {
    return out << comparison.pixelsDiffering << " pixels (" << 100 * comparison.shareDiffering()
               << " %), worst " << comparison.worst << " at " << comparison.worstPlace.x << ", "
               << comparison.worstPlace.y << ", mean " << comparison.mean;
}

namespace {

using Rgba = std::array<std::uint8_t, 4>;

constexpr Rgba kGrey{128, 128, 128, 255};
constexpr Rgba kRed{200, 40, 40, 255};

void paint(Image& image, const PixelRect& rect, const Rgba& color) {
    for (int y = rect.y; y < rect.y + rect.height; ++y) {
        for (int x = rect.x; x < rect.x + rect.width; ++x) {
            std::copy(color.begin(), color.end(),
                      image.pixels.begin() + 4 * (std::ptrdiff_t(y) * image.width + x));
        }
    }
}

Image plain(const Rgba& color, int width = 120, int height = 80) {
    Image image{width, height, std::vector<std::uint8_t>(std::size_t(4) * width * height)};
    paint(image, {0, 0, width, height}, color);
    return image;
}

Image withRect(Image image, const PixelRect& rect, const Rgba& color) {
    paint(image, rect, color);
    return image;
}

/// Every channel one level brighter or darker, but alpha.
Image withNoise(Image image, unsigned seed) {
    std::mt19937 random(seed);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const int step = random() % 2 == 0 ? 1 : -1;
        if (i % 4 != 3) {
            image.pixels[i] = static_cast<std::uint8_t>(std::clamp(image.pixels[i] + step, 0, 255));
        }
    }
    return image;
}

bool isInside(const PixelRect& inner, const PixelRect& outer) {
    return inner.x >= outer.x && inner.y >= outer.y &&
           inner.x + inner.width <= outer.x + outer.width &&
           inner.y + inner.height <= outer.y + outer.height;
}

TEST(ComparePictures, OfOneAndTheSameFindsNothing) {
    const Image picture = withRect(plain(kGrey), {10, 10, 30, 30}, kRed);
    const PictureComparison comparison = comparePictures(picture, picture);
    EXPECT_TRUE(comparison.identical);
    EXPECT_EQ(comparison.mean, 0);
    EXPECT_EQ(comparison.worst, 0);
    EXPECT_EQ(comparison.pixelsDiffering, 0);
    EXPECT_EQ(comparison.pixelsCompared, 120 * 80);
    EXPECT_TRUE(withinLimits(comparison, {0, 0}));
}

TEST(ComparePictures, TakesGreenAndBlueForTheColoursFarthestApart) {
    const PictureComparison comparison =
        comparePictures(plain({0, 255, 0, 255}), plain({0, 0, 255, 255}));
    EXPECT_NEAR(comparison.mean, 1, 1e-5);
    EXPECT_NEAR(comparison.worst, 1, 1e-5);
    EXPECT_EQ(comparison.pixelsDiffering, 120 * 80);
}

/// By the formulas of the paper, on paper: 100^0.7 of the largest difference, above the knee.
TEST(ComparePictures, PutsBlackAndWhiteWhereTheFormulasDo) {
    const PictureComparison comparison =
        comparePictures(plain({0, 0, 0, 255}), plain({255, 255, 255, 255}));
    EXPECT_NEAR(comparison.mean, 0.967, 0.001);
}

TEST(ComparePictures, DoesNotCareWhichOneComesFirst) {
    const Image a = withRect(plain(kGrey), {10, 10, 30, 30}, kRed);
    const Image b = withRect(plain(kGrey), {13, 12, 30, 30}, kRed);
    EXPECT_EQ(comparePictures(a, b).errors, comparePictures(b, a).errors);
}

TEST(ComparePictures, SaysWhereTheWorstPlaceIs) {
    const PixelRect spot{70, 150, 20, 20};
    const Image a = plain(kGrey, 120, 300);
    const PictureComparison comparison = comparePictures(a, withRect(a, spot, kRed));
    EXPECT_TRUE(isInside(comparison.worstPlace, {spot.x - 2, spot.y - 2, 24, 24})) << comparison;
    EXPECT_GE(comparison.pixelsDiffering, 20 * 20);
    EXPECT_LE(comparison.pixelsDiffering, 40 * 40);
    EXPECT_GT(comparison.worst, 0.5);
    EXPECT_LT(comparison.mean, 0.03) << "what the worst place is for";
}

/// Bands of rows are compared one by one; nothing of that shows.
TEST(ComparePictures, FindsTheSameInEveryRow) {
    const Image a = plain(kGrey, 60, 400);
    const double expected = comparePictures(a, withRect(a, {20, 60, 9, 9}, kRed)).worst;
    for (int y = 110; y < 150; y += 3) {
        EXPECT_DOUBLE_EQ(comparePictures(a, withRect(a, {20, y, 9, 9}, kRed)).worst, expected) << y;
    }
}

TEST(ComparePictures, TakesALonePixelForNoPlace) {
    const Image black = plain({0, 0, 0, 255});
    const PictureComparison comparison =
        comparePictures(black, withRect(black, {40, 40, 1, 1}, {255, 255, 255, 255}));
    EXPECT_LE(comparison.worst, kStrictLimits.worst);
    const PictureComparison four =
        comparePictures(black, withRect(black, {40, 40, 2, 2}, {255, 255, 255, 255}));
    EXPECT_GT(four.worst, kStrictLimits.worst);
}

TEST(ComparePictures, LeavesOutWhatIsMasked) {
    const PixelRect spot{40, 20, 20, 20};
    const Image a = plain(kGrey);
    const Image b = withRect(a, spot, kRed);
    const PictureComparison masked = comparePictures(a, b, {{spot}});
    EXPECT_TRUE(masked.identical);
    EXPECT_EQ(masked.mean, 0);
    EXPECT_EQ(masked.pixelsCompared, 120 * 80 - 20 * 20);
    const PictureComparison half = comparePictures(a, b, {{{40, 20, 10, 20}}});
    EXPECT_FALSE(withinLimits(half, kStrictLimits)) << half;
    EXPECT_GE(half.worstPlace.x, 40) << half;
}

TEST(ComparePictures, KeepsWhatIsMaskedFromWhatIsBeside) {
    const Image a = withRect(plain(kGrey), {60, 0, 9, 80}, kRed);
    const Image b = withRect(a, {40, 20, 20, 20}, {255, 255, 255, 255});
    const Image c = withRect(a, {40, 20, 20, 20}, {0, 0, 0, 255});
    const Image other = withRect(plain(kGrey), {62, 0, 9, 80}, kRed);
    const ComparisonOptions options{{{40, 20, 20, 20}}};
    EXPECT_EQ(comparePictures(b, other, options).errors, comparePictures(c, other, options).errors);
}

TEST(ComparePictures, TakesMasksThatOverlapOrReachBeyondThePicture) {
    const Image a = plain(kGrey, 50, 40);
    const ComparisonOptions options{
        {{40, -5, 2000000000, 15}, {-3, -3, 2000000000, 5}, {45, 5, 1, 1}}};
    const PictureComparison comparison = comparePictures(a, plain(kRed, 50, 40), options);
    EXPECT_EQ(comparison.pixelsCompared, 50 * 40 - 50 * 2 - 10 * 8);
    EXPECT_EQ(comparison.pixelsDiffering, comparison.pixelsCompared);
    const PictureComparison nothing = comparePictures(a, plain(kRed, 50, 40), {{{0, 0, 50, 40}}});
    EXPECT_EQ(nothing.pixelsCompared, 0);
    EXPECT_EQ(nothing.mean, 0);
}

TEST(ComparePictures, SeesWhatIsTransparentOnAnyGround) {
    const Image white = plain({255, 255, 255, 255});
    const Image glass = plain({255, 255, 255, 0});
    EXPECT_FALSE(withinLimits(comparePictures(white, glass), kTolerantLimits));
    const Image black = plain({0, 0, 0, 255});
    EXPECT_FALSE(withinLimits(comparePictures(black, plain({0, 0, 0, 0})), kTolerantLimits));
    EXPECT_EQ(comparePictures(glass, plain({9, 90, 200, 0})).mean, 0) << "nobody sees its colour";
}

TEST(ComparePictures, OfDifferentSizesAreAsFarApartAsCanBe) {
    const PictureComparison comparison = comparePictures(plain(kGrey, 9, 9), plain(kGrey, 9, 8));
    EXPECT_FALSE(comparison.sameSize);
    EXPECT_EQ(comparison.worst, 1);
    EXPECT_EQ(comparison.pixelsDiffering, 81);
    EXPECT_FALSE(withinLimits(comparison, {1, 1}));
    EXPECT_TRUE(differencePicture(plain(kGrey, 9, 9), comparison).pixels.empty());
}

TEST(ComparePictures, TakesPicturesThatAreSmallerThanAPlace) {
    const PictureComparison comparison = comparePictures(plain(kGrey, 3, 2), plain(kRed, 3, 2));
    EXPECT_EQ(comparison.worstPlace, (PixelRect{0, 0, 3, 2}));
    EXPECT_NEAR(comparison.worst, comparison.mean, 1e-9);
    EXPECT_TRUE(comparePictures(Image{}, Image{}).identical);
}

TEST(DifferencePicture, GlowsWhereTheyDifferAndIsDarkGreyElsewhere) {
    const Image a = withRect(plain(kGrey), {0, 0, 60, 80}, {255, 255, 255, 255});
    const Image b = withRect(a, {80, 30, 20, 20}, kRed);
    const Image picture = differencePicture(a, comparePictures(a, b));
    const std::uint8_t* glowing = &picture.pixels[4 * (40 * 120 + 90)];
    const std::uint8_t* calm = &picture.pixels[4 * (40 * 120 + 10)];
    EXPECT_GT(glowing[0], 230);
    EXPECT_GT(glowing[0], glowing[2] + 100);
    EXPECT_EQ(calm[0], calm[1]);
    EXPECT_EQ(calm[1], calm[2]);
    EXPECT_LT(calm[0], 128);
}

TEST(ChannelDifference, CountsPixelsAndErrors) {
    const Image a{2, 1, {0, 0, 0, 255, 10, 10, 10, 255}};
    const Image b{2, 1, {0, 0, 2, 255, 10, 10, 61, 255}};
    const ChannelDifference difference = channelDifference(a, b);
    EXPECT_DOUBLE_EQ(difference.largest, 51 / 255.0);
    EXPECT_DOUBLE_EQ(difference.mean, 53 / 255.0 / 8);
    EXPECT_EQ(difference.pixels, 1);
    const ChannelDifference masked = channelDifference(a, b, {{{1, 0, 1, 1}}});
    EXPECT_DOUBLE_EQ(masked.mean, 2 / 255.0 / 4);
    EXPECT_EQ(channelDifference(a, Image{1, 1, {0, 0, 0, 255}}).pixels, 2);
}

/// Pairs of pictures that people tell apart, or don't. docs/notes/picture-comparison.md has their
/// figures in full size.
class PicturePairs : public LightRendererTest {
  protected:
    Image pictureOf(const Stage& stage) { return stage.picture(*renderer_); }

    /// Sideways in the picture [m].
    static Vec3 pixels(const Camera& camera, double count) {
        const double height = 2 * (camera.eye - camera.target).norm() *
                              std::tan(camera.fovY * std::numbers::pi / 360);
        return camera.forward().cross(camera.up).normalized() * (count * height / kHeight);
    }
};

TEST_F(PicturePairs, ABladeThatIsGoneIsADifference) {
    Stage stage(cubeSphere(8));
    const Image bare = pictureOf(stage);
    stage.scene.blade = Blade{Vec3(-0.7, 0.55, 0), Vec3(0.7, 0.55, 0)};
    const PictureComparison comparison = comparePictures(bare, pictureOf(stage));
    EXPECT_GT(comparison.worst, 1.5 * kTolerantLimits.worst) << comparison;
    EXPECT_GT(comparison.shareDiffering(), 2 * kStrictLimits.pixels) << comparison;
}

TEST_F(PicturePairs, APieceMovedByTwoPixelsIsADifference) {
    Stage stage(cubeSphere(8));
    const Image before = pictureOf(stage);
    stage.scene.pieces = {{.shift = pixels(stage.camera, 2)}};
    const PictureComparison comparison = comparePictures(before, pictureOf(stage));
    EXPECT_GT(comparison.worst, 2 * kStrictLimits.worst) << comparison;
    EXPECT_GT(comparison.shareDiffering(), 2 * kStrictLimits.pixels) << comparison;
}

TEST_F(PicturePairs, AShadowThatIsGoneIsADifference) {
    Stage stage(cubeSphere(8));
    const Image lit = pictureOf(stage);
    Bounds elsewhere{Vec3(99, 0, 0), Vec3(100, 1, 1)};
    stage.scene.focus = elsewhere;  // no shadow is drawn but there
    const PictureComparison comparison = comparePictures(lit, pictureOf(stage));
    EXPECT_GT(comparison.worst, 1.1 * kTolerantLimits.worst) << comparison;
    EXPECT_GT(comparison.shareDiffering(), 2 * kStrictLimits.pixels) << comparison;
}

TEST_F(PicturePairs, NoiseOfOneLevelIsNoDifference) {
    Stage stage(cubeSphere(8));
    stage.scene.blade = Blade{Vec3(-0.7, 0.55, 0), Vec3(0.7, 0.55, 0)};
    const Image picture = pictureOf(stage);
    for (unsigned seed = 1; seed <= 3; ++seed) {
        const PictureComparison comparison = comparePictures(picture, withNoise(picture, seed));
        EXPECT_LT(comparison.worst, kStrictLimits.worst / 2)
            << "seed " << seed << ": " << comparison;
        EXPECT_EQ(comparison.pixelsDiffering, 0) << "seed " << seed << ": " << comparison;
        EXPECT_FALSE(comparison.identical);
    }
}

Image goldenPicture(const std::string& name) {
    return readPng(fs::path(KERF_SOURCE_DIR) / "tests/golden" / (name + ".png"));
}

/// Both pairs are of replays, simulated and drawn by llvmpipe and by zink on lavapipe: a sphere
/// that falls onto boxes, and the halves of first-cut on the floor.
TEST(PictureLimits, LetTheRoundingOfAnotherDriverPass) {
    const PictureComparison comparison =
        comparePictures(goldenPicture("boxes-by-llvmpipe"), goldenPicture("boxes-by-zink"));
    EXPECT_FALSE(comparison.identical);
    EXPECT_LT(comparison.worst, kStrictLimits.worst / 2) << comparison;
    EXPECT_LT(comparison.shareDiffering(), kStrictLimits.pixels / 2) << comparison;
}

TEST(PictureLimits, TolerantOnesLetPassWhatAnotherDriverLetFallOtherwise) {
    const PictureComparison comparison =
        comparePictures(goldenPicture("halves-by-llvmpipe"), goldenPicture("halves-by-zink"));
    EXPECT_FALSE(withinLimits(comparison, kStrictLimits)) << comparison;
    EXPECT_TRUE(withinLimits(comparison, kTolerantLimits)) << comparison;
}

}  // namespace
}  // namespace kerf::render

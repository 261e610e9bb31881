#include "render/scene/image.h"

#include "gpu/data_path.h"
#include "render/scene/appearance.h"
#include "render/scene/environment.h"
#include "tests/support/fuzz/targets.h"
#include "tests/support/written_png.h"

namespace kerf::render {
namespace {

Image gradient(int width, int height) {
    Image image{width, height, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (const int channel : {x * 7, y * 11, x * y, 255 - x}) {
                image.pixels.push_back(static_cast<std::uint8_t>(channel));
            }
        }
    }
    return image;
}

std::string readError(const fs::path& file) {
    try {
        readPng(file);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "no error";
}

class ImageFile : public testing::Test {
  protected:
    TemporaryFolder folder_;
    fs::path file_ = folder_.path() / "picture.png";
};

TEST_F(ImageFile, ComesBackAsWrittenAndHasTheSameBytesAgain) {
    const Image image = gradient(33, 17);
    writePng(image, file_);
    const std::string first = readBytes(file_);
    const Image back = readPng(file_);
    EXPECT_EQ(back.width, 33);
    EXPECT_EQ(back.height, 17);
    EXPECT_EQ(back.pixels, image.pixels);
    writePng(gradient(33, 17), file_);
    EXPECT_EQ(readBytes(file_), first);
}

TEST_F(ImageFile, WhatIsNoWholePictureIsRefusedWithItsReason) {
    EXPECT_THAT(readError(file_), HasSubstr(file_.string()));
    EXPECT_THAT(readError(file_), HasSubstr("no such file"));
    EXPECT_THAT(readError(folder_.path()), HasSubstr("not a regular file"));
    writeText(file_, "not a picture");
    EXPECT_THAT(readError(file_), HasSubstr("not a PNG"));
    writePng(gradient(64, 64), file_);
    const std::string bytes = readBytes(file_);
    writeText(file_, bytes.substr(0, bytes.size() / 2));
    EXPECT_THAT(readError(file_), HasSubstr("damaged"));
    writeText(file_, bytes.substr(0, 12));
    EXPECT_THAT(readError(file_), HasSubstr("damaged"));
}

// JPEG files, damaged ones and those that were made to harm their decoder.

using ::testing::ThrowsMessage;

std::string colored() {
    return imageTexts().at(1);
}

std::string bytesOf(std::initializer_list<int> bytes) {
    std::string text;
    std::ranges::transform(bytes, std::back_inserter(text), [](int b) { return char(b); });
    return text;
}

/// A table of quantities that are 1.
const std::string kQuantities = bytesOf({0xff, 0xdb, 0, 67, 0}) + std::string(64, '\1');
/// Two tables of one code each, a bit long, for nothing.
const std::string kCodes = bytesOf({0xff, 0xc4, 0, 20, 0, 1}) + std::string(16, '\0') +
                           bytesOf({0xff, 0xc4, 0, 20, 16, 1}) + std::string(16, '\0');

/// A grey picture of 8 x 8 pixels, sent in so many scans: the first of its mean, each other one of
/// a bit of one of its waves, all of which are 0.
std::string inScans(int scans) {
    constexpr int kBits = 13;  // of a wave
    std::string text = bytesOf({0xff, 0xd8}) + kQuantities +
                       bytesOf({0xff, 0xc2, 0, 11, 8, 0, 8, 0, 8, 1, 1, 0x11, 0}) + kCodes;
    const auto scan = [](int wave, int bits) {
        return bytesOf({0xff, 0xda, 0, 8, 1, 1, 0, wave, wave, bits, 0x7f});
    };
    text += scan(0, 0);
    for (int i = 0; i < scans - 1; ++i) {
        const int low = kBits - i % (kBits + 1);
        text += scan(1 + i / (kBits + 1), low == kBits ? low : 16 * (low + 1) + low);
    }
    return text + bytesOf({0xff, 0xd9});
}

TEST(Jpeg, IsReadAsItWasWritten) {
    const Image image = decodeJpeg(colored());
    EXPECT_EQ(sizeOfJpeg(colored()), (PixelRect{0, 0, 9, 9}));
    ASSERT_EQ(image.pixels.size(), 4U * 9 * 9);
    // The written colours change from pixel to pixel, which the format blurs; opaque it stays.
    EXPECT_NEAR(image.pixels[0], 0, 60);
    EXPECT_NEAR(image.pixels[1], 255, 60);
    EXPECT_EQ(image.pixels[3], 255);
}

TEST(Jpeg, CutOffAnywhereItIsRefused) {
    for (const std::string& text : {colored(), inScans(30)}) {
        for (std::size_t size = 0; size < text.size() - 2; ++size) {
            EXPECT_THROW(decodeJpeg(text.substr(0, size)), std::runtime_error) << size;
        }
    }
}

TEST(Jpeg, WhatIsDamagedIsRefusedOrAPictureOfItsSize) {
    for (std::size_t at = 0; at < colored().size(); ++at) {
        std::string text = colored();
        text[at] = static_cast<char>(~text[at]);
        try {
            const Image image = decodeJpeg(text);
            EXPECT_EQ(image.pixels.size(), 4 * std::size_t(image.width) * image.height) << at;
        } catch (const std::runtime_error& error) {
            EXPECT_THAT(error.what(), HasSubstr("damaged")) << at;
        }
    }
}

TEST(Jpeg, ScansHaveAnEnd) {
    EXPECT_EQ(decodeJpeg(inScans(500)).width, 8);
    EXPECT_THAT([] { decodeJpeg(inScans(502)); },
                ThrowsMessage<std::runtime_error>(HasSubstr("damaged")));
}

// As they are in files for print: each ink by what it leaves of the light.
TEST(Jpeg, InksAreMixed) {
    std::string text = bytesOf({0xff, 0xd8, 0xff, 0xee, 0, 14}) + "Adobe" +
                       bytesOf({0, 100, 0, 0, 0, 0, 0}) + kQuantities +
                       bytesOf({0xff, 0xc0, 0, 20, 8, 0, 8, 0, 8, 4});
    for (int ink = 1; ink <= 4; ++ink) {
        text += bytesOf({ink, 0x11, 0});
    }
    text += kCodes + bytesOf({0xff, 0xda, 0, 14, 4, 1, 0, 2, 0, 3, 0, 4, 0, 0, 63, 0}) +
            bytesOf({0, 0xff, 0xd9});
    const Image image = decodeJpeg(text);  // half of each
    ASSERT_EQ(image.pixels.size(), 4U * 8 * 8);
    EXPECT_THAT((std::vector<int>(image.pixels.begin(), image.pixels.begin() + 4)),
                ElementsAre(64, 64, 64, 255));
}

Panorama even(float light) {
    return {64, 32, std::vector<Vec3f>(64 * 32, Vec3f::Constant(light))};
}

float lightOf(std::uint8_t byte) {
    const float root = float(byte) / 255;
    return kEnvironmentRange * root * root;
}

TEST(Environment, EvenLightIsTheSameInAllDirectionsAndLevels) {
    const Environment environment = prefilter(even(0.5F));
    for (const auto& level : environment.levels) {
        for (std::size_t i = 0; i < level.size(); i += 4) {
            ASSERT_NEAR(lightOf(level[i]), 0.5F, 0.02F);
        }
    }
    EXPECT_NEAR(environment.matt[0].x(), 0.5F, 0.005F);
    EXPECT_NEAR(environment.matt[2].norm(), 0, 0.005F);
}

TEST(Environment, LightFromAboveShinesOnWhatFacesUp) {
    Panorama panorama = even(0);
    std::fill_n(panorama.pixels.begin(), 64 * 8, Vec3f::Constant(2));
    const Environment environment = prefilter(panorama);
    EXPECT_GT(environment.matt[2].x(), 0.1F);
    EXPECT_NEAR(environment.matt[1].x(), 0, 1e-4F);
    EXPECT_NEAR(environment.matt[3].x(), 0, 1e-4F);
    // +y lies in the middle of the unfolded octahedron, -y in its corners.
    const auto& sharp = environment.levels[0];
    const std::size_t middle =
        Environment::kSide * (Environment::kSide / 2) + Environment::kSide / 2;
    EXPECT_NEAR(lightOf(sharp[4 * middle]), 2, 0.05F);
    EXPECT_EQ(sharp[0], 0);
}

TEST(Environment, RougherSurfacesMirrorHigherLevels) {
    EXPECT_EQ(mirrorLevel(0).level, 0);
    EXPECT_EQ(mirrorLevel(0.5F).level, 2);
    EXPECT_EQ(mirrorLevel(1).level, Environment::kLevels - 1);
}

TEST(Environment, TexelsThatMeetAtASeamAreTheSame) {
    Panorama panorama = even(0);
    for (std::size_t i = 0; i < panorama.pixels.size(); ++i) {
        panorama.pixels[i] = Vec3f::Constant(float(i % 64) / 32);
    }
    const Environment environment = prefilter(panorama);
    for (int level = 0; level < Environment::kLevels; ++level) {
        const int side = Environment::kSide >> level;
        for (int i = 0; i < side; ++i) {
            const int twin = side - 1 - i;
            EXPECT_NEAR(environment.levels[level][std::size_t(4) * i],
                        environment.levels[level][std::size_t(4) * twin], 1);
        }
    }
}

TEST(Environment, OurStudiosCanBeRead) {
    for (const char* name : {"studio-dark.hdr", "studio-bright.hdr"}) {
        const Panorama panorama =
            readPanorama(gpu::dataPath("assets/environments") / std::string(name));
        EXPECT_EQ(panorama.width, 256);
        EXPECT_EQ(panorama.height, 128);
    }
}

TEST(Environment, WhatIsNoPanoramaIsRefusedWithASentence) {
    EXPECT_THAT([] { readPanorama(gpu::dataPath("shaders/render/surface.frag")); },
                ThrowsMessage<std::runtime_error>(HasSubstr("is no panorama")));
}

}  // namespace
}  // namespace kerf::render

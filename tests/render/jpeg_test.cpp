// JPEG files, damaged ones and those that were made to harm their decoder.
#include <gmock/gmock.h>

#include <stdexcept>

#include "render/scene/appearance.h"
#include "tests/support/fuzz/targets.h"

namespace kerf::render {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

std::string colored() {
    return test::imageTexts().at(1);
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
                ::testing::ElementsAre(64, 64, 64, 255));
}

}  // namespace
}  // namespace kerf::render

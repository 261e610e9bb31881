#include "render/scene/environment.h"

#include <gtest/gtest.h>

#include "gpu/data_path.h"

namespace kerf::render {
namespace {

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
    const std::filesystem::path file = gpu::dataPath("shaders/render/surface.frag");
    try {
        readPanorama(file);
        FAIL();
    } catch (const std::runtime_error& problem) {
        EXPECT_NE(std::string(problem.what()).find("is no panorama"), std::string::npos);
    }
}

}  // namespace
}  // namespace kerf::render

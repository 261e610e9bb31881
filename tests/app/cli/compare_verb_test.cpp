#include "app/cli/compare_verb.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "app/cli/verb.h"
#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "tests/support/png_head.h"
#include "tests/support/run_kerf.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/written_png.h"

namespace kerf::app {
namespace {

using render::PixelRect;
using testing::HasSubstr;

constexpr int kSide = 64;

class CompareVerb : public testing::Test {
  protected:
    CompareVerb() {
        arguments_.a = write("a.png", 100);
        arguments_.b = write("b.png", 100);
        arguments_.diff = folder_ / "diff.png";
    }
    /// A grey picture, with a brighter square of ten pixels if that has another level.
    std::filesystem::path write(const char* name, std::uint8_t level, std::uint8_t square = 0,
                                int height = kSide) {
        render::Image image{kSide, height,
                            std::vector<std::uint8_t>(std::size_t(4) * kSide * height, level)};
        for (int i = 0; i < (square == 0 ? 0 : 400); ++i) {
            const int row = 20 + i / 40;
            image.pixels[std::size_t(4) * (row * kSide + 5) + i % 40] = square;
        }
        for (std::size_t i = 3; i < image.pixels.size(); i += 4) {
            image.pixels[i] = 255;
        }
        test::writePng(image, folder_ / name);
        return folder_ / name;
    }
    int run() {
        out_.str("");
        return runCompare(arguments_, out_);
    }
    nlohmann::json report() {
        arguments_.json = true;
        run();
        return nlohmann::json::parse(out_.str());
    }
    bool wroteDiff() const { return std::filesystem::exists(arguments_.diff); }

    test::TemporaryFolder folder_;
    CompareArguments arguments_;
    std::ostringstream out_;
};

TEST_F(CompareVerb, EqualPicturesGiveZeroAndNoDiff) {
    EXPECT_EQ(run(), 0);
    EXPECT_EQ(out_.str(), "equal\n");
    EXPECT_FALSE(wroteDiff());
}

TEST_F(CompareVerb, DifferentPicturesGiveOneAndADiffAndAPlace) {
    write("b.png", 100, 200);
    EXPECT_EQ(run(), 1);
    EXPECT_THAT(out_.str(), testing::StartsWith("differ: "));
    EXPECT_THAT(out_.str(), HasSubstr("of 4096 pixels differ visibly"));
    EXPECT_THAT(out_.str(), testing::ContainsRegex("around x (9|1[0-2]), y 2[3-7],"));
    EXPECT_EQ(render::readPng(arguments_.diff).width, kSide);
}

TEST_F(CompareVerb, WhatNobodySeesIsEqualWithinTheLimitsOnly) {
    write("b.png", 101);
    EXPECT_EQ(run(), 0);
    EXPECT_THAT(out_.str(), testing::StartsWith("equal within the limits: 0 of 4096 pixels"));
    EXPECT_FALSE(wroteDiff());
}

TEST_F(CompareVerb, TolerantLimitsAreWider) {
    write("b.png", 100, 112);
    EXPECT_EQ(report()["equal"], false);
    arguments_.tolerant = true;
    EXPECT_EQ(report()["equal"], true);
    EXPECT_EQ(report()["limits"]["worst"], render::kTolerantLimits.worst);
    write("b.png", 100, 200);
    EXPECT_EQ(report()["equal"], false);
}

TEST_F(CompareVerb, AThresholdForgivesByTheMeanOfTheChannels) {
    write("b.png", 110);
    arguments_.threshold = 0.03;
    EXPECT_EQ(run(), 0) << "10/255 in three of four channels";
    EXPECT_THAT(out_.str(), testing::StartsWith("equal within the threshold: mean difference of a "
                                                "channel 0.0294 (threshold 0.03)"));
    arguments_.threshold = 0;
    EXPECT_EQ(run(), 1);
    EXPECT_TRUE(wroteDiff());
}

TEST_F(CompareVerb, OtherSizeGivesOneAndSaysThatThereIsNoDiff) {
    write("b.png", 100, 0, 30);
    arguments_.threshold = 1;
    EXPECT_EQ(run(), 1);
    EXPECT_EQ(out_.str(),
              "differ in size: 64x64 and 64x30; no picture of the difference is written\n");
    EXPECT_FALSE(wroteDiff());
    EXPECT_EQ(report()["diff"], nullptr);
}

TEST_F(CompareVerb, MasksAreLeftOut) {
    write("b.png", 100, 200);
    arguments_.masks = {{5, 20, 10, 10}};
    EXPECT_EQ(run(), 0);
    EXPECT_EQ(out_.str(), "equal outside the masks\n");
    arguments_.masks = {{5, 20, 10, 5}};
    EXPECT_EQ(run(), 1);
}

TEST_F(CompareVerb, MasksThatMissThePictureOrHideItAreInputErrors) {
    arguments_.masks = {{64, 0, 5, 5}};
    EXPECT_THAT([this] { run(); }, testing::ThrowsMessage<InputError>(
                                       HasSubstr("--mask 64,0,5,5: this lies outside")));
    arguments_.masks = {{0, 0, 64, 20}, {0, 20, 99, 99}};
    EXPECT_THAT([this] { run(); }, testing::ThrowsMessage<InputError>(HasSubstr("leave nothing")));
}

TEST(ReadMask, TakesFourWholeNumbersAlone) {
    EXPECT_EQ(readMask("10,0,300,40"), (PixelRect{10, 0, 300, 40}));
    for (const char* text : {"", "1", "1,2,3", "1,2,3,4,5", "1,2,3,4,", "-1,2,3,4", "1,2,0,4",
                             "1,2,3,x", "1, 2,3,4", "1.5,2,3,4", "1,2,3,99999999999"}) {
        EXPECT_EQ(readMask(text), std::nullopt) << text;
    }
}

TEST_F(CompareVerb, UnreadablePictureIsAnInputErrorThatNamesIt) {
    arguments_.b = folder_ / "missing.png";
    EXPECT_THAT([this] { run(); }, testing::ThrowsMessage<InputError>(HasSubstr("missing.png")));
    EXPECT_EQ(out_.str(), "");
}

TEST_F(CompareVerb, DifferenceThatCannotBeWrittenIsAnOutputError) {
    write("b.png", 100, 200);
    arguments_.diff = folder_ / "nowhere" / "diff.png";
    EXPECT_THAT([this] { run(); }, testing::ThrowsMessage<OutputError>(HasSubstr("nowhere")));
}

TEST_F(CompareVerb, TheDifferenceTakesThePlaceOfNoInputAndNoPipe) {
    arguments_.b = write("b.png", 100, 200);
    arguments_.diff = folder_ / "link.png";
    std::filesystem::create_symlink("a.png", arguments_.diff);
    EXPECT_THAT([this] { run(); }, testing::ThrowsMessage<UsageError>(HasSubstr("link.png")));
    arguments_.diff = folder_ / "pipe";
    ASSERT_EQ(::mkfifo(arguments_.diff.c_str(), 0600), 0);
    EXPECT_THAT([this] { run(); }, testing::ThrowsMessage<OutputError>(HasSubstr("pipe")));
    EXPECT_TRUE(std::filesystem::is_fifo(arguments_.diff));
}

TEST_F(CompareVerb, ALinkStaysAndWhatItLeadsToIsReplaced) {
    arguments_.b = write("b.png", 100, 200);
    write("old.png", 7);
    arguments_.diff = folder_ / "link.png";
    std::filesystem::create_symlink("old.png", arguments_.diff);
    EXPECT_EQ(run(), 1);
    EXPECT_TRUE(std::filesystem::is_symlink(arguments_.diff));
    EXPECT_NE(render::readPng(folder_ / "old.png").pixels[0], 7);
}

TEST_F(CompareVerb, JsonIsOneObjectWithTheKeysOfTheContract) {
    write("b.png", 100, 200);
    const nlohmann::json json = report();
    EXPECT_EQ(json["equal"], false);
    EXPECT_EQ(json["same_size"], true);
    EXPECT_GE(json["pixels_differing"], 100);
    EXPECT_GT(json["worst"], 0.3);
    EXPECT_LE(json["worst"], 1);
    EXPECT_GT(json["mean"], 0);
    EXPECT_LT(json["mean"], json["worst"]);
    EXPECT_EQ(json["worst_at"].size(), 4U);
    EXPECT_EQ(json["limits"]["pixels"], render::kStrictLimits.pixels);
    EXPECT_EQ(json["differing_pixels"], 100);
    EXPECT_DOUBLE_EQ(json["max_error"], 100 / 255.0);
    EXPECT_EQ(json["threshold"], nullptr);
    EXPECT_EQ(json["diff"], arguments_.diff.string());
}

/// A sphere that has just met the floor, in a small picture.
std::string droppedSphere(double ispcStiffness) {
    return R"({"format": "kerf-session", "version": 1, "model": {"builtin": "sphere80"},
      "params": {"floor": -0.6, "ispc_stiffness": )" +
           std::to_string(ispcStiffness) + R"(}, "steps": 50, "events": [
        {"step": 50, "type": "screenshot", "file": "end.png", "width": 320, "height": 180}]})";
}

TEST(CompareReplays, OfTwoStiffnessesTellsThemApart) {
    const test::TemporaryFolder folder;
    for (const auto& [name, stiffness] : {std::pair{"firm", 0.5}, std::pair{"soft", 0.35}}) {
        test::writeText(folder / (std::string(name) + ".kerf.json"), droppedSphere(stiffness));
        const test::ProgramRun replay = test::runKerf(
            {"replay", folder / (std::string(name) + ".kerf.json"), "--out", folder / name});
        ASSERT_EQ(replay.exitCode, 0) << replay.errors;
    }
    const test::ProgramRun compared =
        test::runKerf({"compare", folder / "firm/end.png", folder / "soft/end.png", "--json"});
    EXPECT_EQ(compared.exitCode, 1) << compared.out;
    const nlohmann::json json = nlohmann::json::parse(compared.out);
    EXPECT_GT(json["worst"], render::kStrictLimits.worst) << compared.out;
    EXPECT_LT(json["mean_error"], 0.002) << "too little for a mean over all pixels";
}

TEST_F(CompareVerb, APictureThatIsTooLargeIsNotCalledDamaged) {
    test::writeText(folder_ / "large.png", test::pngHead(30000, 30000));
    arguments_.a = folder_ / "large.png";
    try {
        run();
        FAIL() << "it was read";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("more than 512 million pixels"));
    }
}

}  // namespace
}  // namespace kerf::app

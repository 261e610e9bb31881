#include "app/cli/compare_verb.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "app/files/file_io.h"
#include "app/files/model_source.h"
#include "render/scene/image.h"
#include "tests/support/temporary_folder.h"

namespace kerf::app {
namespace {

using testing::HasSubstr;

class CompareVerb : public testing::Test {
  protected:
    CompareVerb() {
        arguments_.a = write("a.png", 10, 4);
        arguments_.b = write("b.png", 10, 4);
        arguments_.diff = folder_ / "diff.png";
    }
    std::filesystem::path write(const char* name, std::uint8_t level, int height) {
        const std::size_t bytes = std::size_t(4) * 4 * std::size_t(height);
        render::writePng({4, height, std::vector<std::uint8_t>(bytes, level)}, folder_ / name);
        return folder_ / name;
    }
    int run() { return compareVerb(arguments_, out_); }
    bool wroteDiff() const { return std::filesystem::exists(arguments_.diff); }

    test::TemporaryFolder folder_;
    CompareArguments arguments_;
    std::ostringstream out_;
};

TEST_F(CompareVerb, EqualPicturesGiveZeroAndNoDiff) {
    EXPECT_EQ(run(), 0);
    EXPECT_THAT(out_.str(), HasSubstr("equal"));
    EXPECT_FALSE(wroteDiff());
}

TEST_F(CompareVerb, DifferentPicturesGiveOneAndADiff) {
    write("b.png", 20, 4);
    EXPECT_EQ(run(), 1);
    EXPECT_THAT(out_.str(), HasSubstr("differ: mean 0.039"));
    EXPECT_TRUE(wroteDiff());
}

TEST_F(CompareVerb, ThresholdForgives) {
    write("b.png", 20, 4);
    arguments_.threshold = 0.04;
    EXPECT_EQ(run(), 0);
    EXPECT_FALSE(wroteDiff());
}

TEST_F(CompareVerb, OtherSizeGivesOne) {
    write("b.png", 10, 5);
    arguments_.threshold = 1;
    EXPECT_EQ(run(), 1);
    EXPECT_THAT(out_.str(), HasSubstr("4x4 and 4x5"));
}

TEST_F(CompareVerb, UnreadablePictureIsAnInputErrorThatNamesIt) {
    arguments_.b = folder_ / "missing.png";
    EXPECT_THAT([this] { run(); }, testing::ThrowsMessage<InputError>(HasSubstr("missing.png")));
    EXPECT_EQ(out_.str(), "");
}

TEST_F(CompareVerb, DifferenceThatCannotBeWrittenIsAnOutputError) {
    write("b.png", 20, 4);
    arguments_.diff = folder_ / "nowhere" / "diff.png";
    EXPECT_THAT([this] { run(); }, testing::ThrowsMessage<OutputError>(HasSubstr("nowhere")));
}

TEST_F(CompareVerb, JsonIsOneObject) {
    write("b.png", 20, 4);
    arguments_.json = true;
    EXPECT_EQ(run(), 1);
    const nlohmann::json report = nlohmann::json::parse(out_.str());
    EXPECT_EQ(report["equal"], false);
    EXPECT_EQ(report["differing_pixels"], 16);
}

}  // namespace
}  // namespace kerf::app

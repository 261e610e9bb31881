// Folders of expectations that come from somebody else: what is read, written and removed stays
// inside of them.
#include "app/regression/judgement.h"
#include "app/regression/picture_check.h"
#include "app/regression/run_trace.h"
#include "app/regression/test_session.h"

namespace kerf::app {
namespace {

render::Image grey(int brightness) {
    return {4, 4, std::vector<std::uint8_t>(4 * 4 * 4, static_cast<std::uint8_t>(brightness))};
}

/// A run that took a picture, a folder for what is expected of it, and one that is nobody's
/// business.
class ExpectationPaths : public ::testing::Test {
  protected:
    ExpectationPaths() {
        for (const fs::path& made : {run_, expected_, elsewhere_}) {
            fs::create_directories(made);
        }
        writePicture(grey(200), run_ / "a.png");
        writePicture(grey(7), elsewhere_ / "kept.png");
        writeText(run_ / kHashesFile, "step,state_hash,topology_hash\n");
        kept_ = readBytes(elsewhere_ / "kept.png");
        results_.folder = run_;
        results_.driver = {"llvmpipe", "4.5"};
        results_.pictures = {{"a.png", 0}};
        results_.hashes = HashTrace::read(run_ / kHashesFile);
    }
    ~ExpectationPaths() override {
        EXPECT_EQ(readBytes(elsewhere_ / "kept.png"), kept_);
        EXPECT_THAT(entries(elsewhere_), SizeIs(1));
    }

    static std::vector<fs::path> entries(const fs::path& folder) {
        std::vector<fs::path> found;
        for (const auto& entry : fs::directory_iterator(folder)) {
            found.push_back(entry.path());
        }
        return found;
    }
    /// The sentence about an expectation of this picture.
    std::string refusalOf(const std::string& picture) {
        Expectation expectation;
        expectation.pictures = {{picture, {}, {}}};
        writeText(expected_ / kExpectedFile, formatExpectation(expectation));
        return inputErrorOf([&] { readExpectation(expected_ / kExpectedFile); });
    }

    test::TemporaryFolder folder_;
    fs::path run_ = folder_ / "run";
    fs::path expected_ = folder_ / "x.expected";
    fs::path elsewhere_ = folder_ / "elsewhere";
    std::string kept_;
    RunResults results_;
};

TEST_F(ExpectationPaths, PicturesOutsideOfTheFolderAreRefused) {
    for (const std::string& name :
         {std::string("../elsewhere/kept.png"), (elsewhere_ / "kept.png").string(),
          std::string("a/../../elsewhere/kept.png"), std::string(".."), std::string("a.png\0", 6),
          std::string(5000, 'a')}) {
        EXPECT_THAT(refusalOf(name), HasSubstr("is no file inside the folder")) << name;
    }
    EXPECT_EQ(refusalOf("~/a.png"), "") << "a folder of that name";
}

TEST_F(ExpectationPaths, APictureOfANameThatNoFileHasIsMissing) {
    writeExpectation(expected_, results_);
    const std::string name = std::string(300, 'a') + ".png";
    Expectation expectation = readExpectation(expected_ / kExpectedFile);
    expectation.pictures = {{name, {}, {}}};
    writeText(expected_ / kExpectedFile, formatExpectation(expectation));
    const Judgement judgement = judge(expected_, results_, folder_ / "diff");
    EXPECT_TRUE(judgement.pictures.front().missing);
}

TEST_F(ExpectationPaths, NothingIsWrittenOrRemovedThroughALinkToTheFolder) {
    fs::remove_all(expected_);
    fs::create_directory_symlink(elsewhere_, expected_);
    EXPECT_THROW(writeExpectation(expected_, results_), OutputError);
}

TEST_F(ExpectationPaths, NoPictureIsWrittenThroughALink) {
    fs::create_symlink(elsewhere_ / "kept.png", expected_ / "a.png");
    EXPECT_THROW(writeExpectation(expected_, results_), OutputError);
    fs::remove(expected_ / "a.png");
    writeExpectation(expected_, results_);
    EXPECT_EQ(readBytes(expected_ / "a.png"), readBytes(run_ / "a.png"));
}

TEST_F(ExpectationPaths, PicturesBehindALinkAreNotRemoved) {
    fs::create_directory_symlink(elsewhere_, expected_ / "old");
    fs::create_symlink(elsewhere_ / "kept.png", expected_ / "stale.png");
    writeExpectation(expected_, results_);
    EXPECT_FALSE(fs::is_symlink(expected_ / "stale.png")) << "the link is not listed, so it goes";
}

TEST_F(ExpectationPaths, NoPictureIsReadThroughALinkThatLeadsOut) {
    writeExpectation(expected_, results_);
    fs::remove(expected_ / "a.png");
    fs::create_symlink(elsewhere_ / "kept.png", expected_ / "a.png");
    EXPECT_THAT(inputErrorOf([&] { judge(expected_, results_, folder_ / "diff"); }),
                HasSubstr("leads out of the folder of expectations"));
}

TEST_F(ExpectationPaths, DifferencesAreNotWrittenThroughALink) {
    fs::create_directory_symlink(elsewhere_, run_ / "diff");
    fs::create_directories(folder_ / "reference");
    writePicture(grey(3), folder_ / "reference/a.png");
    EXPECT_THROW(compareWithReference({"a.png"}, folder_ / "reference", run_), OutputError);
}

TEST_F(ExpectationPaths, ReferencesAreNotRenewedThroughALink) {
    fs::create_directories(folder_ / "reference");
    fs::create_symlink(elsewhere_ / "kept.png", folder_ / "reference/a.png");
    EXPECT_THROW(renewReference({{"a.png", false, ""}}, folder_ / "reference", run_), OutputError);
}

/// Two pieces before the first step, one after some.
PieceTrace someCourse() {
    return {{0, {{1.5, {Vec3(-1, 0, 2), Vec3(1, 4, 3)}}, {0.5, {Vec3(0, 0, 0), Vec3(1, 1, 1)}}}},
            {7, {{2, {Vec3(-2, -1, 0), Vec3(2, 3, 3)}}}}};
}

TEST(RunCourse, PiecesAreReadAsTheyWereWritten) {
    const test::TemporaryFolder folder;
    const std::string text = formatPieces(someCourse());
    writeText(folder / "pieces.csv", text);
    const PieceTrace read = readPieces(folder / "pieces.csv");
    ASSERT_EQ(read.size(), 2U);
    ASSERT_EQ(read.at(0).size(), 2U);
    EXPECT_EQ(read.at(0)[1].volume, 0.5);
    EXPECT_EQ(read.at(7)[0].box.high, Vec3(2, 3, 3));
    EXPECT_EQ(formatPieces(read), text);
    EXPECT_EQ(lastStepOf(read), 7);
    EXPECT_EQ(lastStepOf({}), -1);
}

TEST(RunCourse, TheBoxAroundAllPiecesHoldsEachOfThem) {
    const Bounds box = boxOf(someCourse().at(0), &PieceBox::box);
    EXPECT_EQ(box.low, Vec3(-1, 0, 0));
    EXPECT_EQ(box.high, Vec3(1, 4, 3));
}

TEST(RunCourse, CountsAreReadAsTheyWereWritten) {
    const test::TemporaryFolder folder;
    const std::string text = formatTrace({{2.25, 1, 10, 16}, {2, 2, 14, 24}});
    writeText(folder / "course.csv", text);
    const RunTrace read = readTrace(folder / "course.csv");
    ASSERT_EQ(read.size(), 2U);
    EXPECT_EQ(read[0].triangles, 16);
    EXPECT_EQ(formatTrace(read), text);
}

}  // namespace
}  // namespace kerf::app

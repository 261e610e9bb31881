#include "app/regression/run_trace.h"

#include <gtest/gtest.h>

#include "sim/base/math.h"
#include "tests/support/temporary_folder.h"

namespace kerf::app {
namespace {

/// Two pieces before the first step, one after some.
PieceTrace someCourse() {
    return {{0, {{1.5, {Vec3(-1, 0, 2), Vec3(1, 4, 3)}}, {0.5, {Vec3(0, 0, 0), Vec3(1, 1, 1)}}}},
            {7, {{2, {Vec3(-2, -1, 0), Vec3(2, 3, 3)}}}}};
}

TEST(RunCourse, PiecesAreReadAsTheyWereWritten) {
    const test::TemporaryFolder folder;
    const std::string text = formatPieces(someCourse());
    test::writeText(folder / "pieces.csv", text);
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
    test::writeText(folder / "course.csv", text);
    const RunTrace read = readTrace(folder / "course.csv");
    ASSERT_EQ(read.size(), 2U);
    EXPECT_EQ(read[0].triangles, 16);
    EXPECT_EQ(formatTrace(read), text);
}

}  // namespace
}  // namespace kerf::app

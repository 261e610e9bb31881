#include <gtest/gtest.h>

#include "app/editor/steps/step_clock.h"

namespace kerf::app {
namespace {

constexpr double kAll = 1000;

TEST(TimeLeft, IsUnknownBeforeThereIsARate) {
    TimeLeft left;
    EXPECT_FALSE(left.at(0, 0, kAll));
    EXPECT_FALSE(left.at(1, 0, kAll));
    EXPECT_FALSE(left.at(2, 7, 0)) << "without an end";
}

TEST(TimeLeft, OfASteadyRateRunsDownWithTheClock) {
    TimeLeft left;
    left.at(0, 0, kAll);
    for (int second = 1; second < 100; ++second) {
        EXPECT_NEAR(left.at(second, 10 * second, kAll).value(), 100 - second, 1);
    }
}

// It was taken from the last step alone: 35 s, 7 s, 194 s, 14 s in a row.
TEST(TimeLeft, DoesNotJumpWhereStepsTakeUnlikeTimes) {
    TimeLeft left;
    double now = 0;
    left.at(now, 0, kAll);
    std::optional<double> before;
    for (int step = 1; step <= 600; ++step) {
        now += step % 10 == 0 ? 0.5 : 0.05;
        const std::optional<double> shown = left.at(now, step, kAll);
        if (before && now > 3) {
            EXPECT_LT(std::abs(*shown - *before), 5) << step;
        }
        before = shown;
    }
    EXPECT_NEAR(*before, 0.095 * 400, 8);
}

TEST(TimeLeft, FollowsALongStepByTheClock) {
    TimeLeft left;
    left.at(0, 0, 10);
    left.at(40, 1, 10);
    const double then = left.at(80, 2, 10).value();
    EXPECT_NEAR(left.at(90, 2, 10).value(), then - 10, 5);
}

TEST(TimeLeft, BeginsAnewWithOtherWork) {
    TimeLeft left;
    ui::WorkState work{.title = "Cutting", .stage = "", .done = 1, .all = 2};
    left.follow(work);
    work.done = 2;
    left.follow(work);
    EXPECT_TRUE(work.left);
    work.title = "Exporting";
    left.follow(work);
    EXPECT_FALSE(work.left);
}

TEST(TimeText, SaysWhatItIs) {
    const auto text = [](std::optional<double> left) {
        ui::WorkState work{.title = "", .stage = "", .seconds = 12.2};
        work.left = left;
        return timeText(work);
    };
    EXPECT_EQ(text(std::nullopt), ", 12 s so far");
    EXPECT_EQ(text(18.2), ", about 20 s left");
    EXPECT_EQ(text(3.2), ", about 4 s left");
    EXPECT_EQ(text(0.4), ", almost done");
    EXPECT_EQ(text(200), ", about 3 min left");
}

}  // namespace
}  // namespace kerf::app

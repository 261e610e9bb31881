#include "ui/plot_math.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <random>

namespace kerf::ui {
namespace {

using ::testing::DoubleNear;
using ::testing::Pointwise;

TEST(NiceTicks, AreRoundNumbersInsideTheRange) {
    EXPECT_THAT(niceTicks({0, 1}, 6).values,
                Pointwise(DoubleNear(1e-12), std::vector<double>{0, 0.2, 0.4, 0.6, 0.8, 1}));
    EXPECT_THAT(niceTicks({-3, 18}, 5).values,
                Pointwise(DoubleNear(1e-12), std::vector<double>{0, 10}));
    EXPECT_THAT(niceTicks({99.6, 100.1}, 4).values,
                Pointwise(DoubleNear(1e-9), std::vector<double>{99.6, 99.8, 100.0}));
}

TEST(NiceTicks, LabelsTellNeighboursApart) {
    EXPECT_EQ(niceTicks({0, 100}, 6).decimals, 0);
    EXPECT_EQ(niceTicks({0, 1}, 6).decimals, 1);
    EXPECT_EQ(niceTicks({0, 0.1}, 6).decimals, 2);
    EXPECT_EQ(niceTicks({99.99, 100}, 3).decimals, 3);
}

TEST(NiceTicks, NothingToMarkInAnEmptyRange) {
    EXPECT_TRUE(niceTicks({1, 1}, 5).values.empty());
    EXPECT_TRUE(niceTicks({2, 1}, 5).values.empty());
    EXPECT_TRUE(niceTicks({0, std::numeric_limits<double>::infinity()}, 5).values.empty());
}

TEST(NiceTicks, KeepTheirPromisesForAnyRange) {
    const unsigned seed = 20240607;
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> middle(-1000, 1000);
    std::uniform_real_distribution<double> magnitude(-4, 4);
    for (int round = 0; round < 2000; ++round) {
        const double low = middle(random);
        const PlotRange range{low, low + std::pow(10.0, magnitude(random))};
        const int maxCount = 2 + round % 9;
        const PlotTicks ticks = niceTicks(range, maxCount);
        ASSERT_LE(static_cast<int>(ticks.values.size()), maxCount);
        for (std::size_t i = 0; i < ticks.values.size(); ++i) {
            ASSERT_GE(ticks.values[i], range.low - 1e-6 * range.span());
            ASSERT_LE(ticks.values[i], range.high + 1e-6 * range.span());
            ASSERT_TRUE(i == 0 || ticks.values[i] > ticks.values[i - 1]);
        }
    }
}

TEST(PaddedRange, LeavesAMarginAroundTheValues) {
    const std::vector<PlotPoint> points{{0, 10}, {1, 30}};
    const PlotRange range = paddedRange(points, 1);
    EXPECT_DOUBLE_EQ(range.low, 9);
    EXPECT_DOUBLE_EQ(range.high, 31);
}

TEST(PaddedRange, NeverShowsLessThanTheSmallestSpan) {
    const std::vector<PlotPoint> points{{0, 100}, {1, 100}};
    EXPECT_EQ(paddedRange(points, 1), (PlotRange{99.5, 100.5}));
}

TEST(PaddedRange, IgnoresWhatIsNotFinite) {
    const std::vector<PlotPoint> points{{0, std::nan("")}, {1, 5}, {2, HUGE_VAL}};
    EXPECT_EQ(paddedRange(points, 2), (PlotRange{4, 6}));
    EXPECT_EQ(paddedRange({}, 2), (PlotRange{0, 2}));
}

TEST(GatherColumns, KeepsTheExtremesOfEachColumn) {
    const std::vector<PlotPoint> points{{0.0, 1}, {0.1, 9}, {0.2, 2}, {0.9, 5}};
    const std::vector<PlotColumn> columns = gatherColumns(points, {0, 1}, 2);
    ASSERT_EQ(columns.size(), 2U);
    EXPECT_EQ(columns[0].column, 0);
    EXPECT_DOUBLE_EQ(columns[0].low, 1);
    EXPECT_DOUBLE_EQ(columns[0].high, 9);
    EXPECT_DOUBLE_EQ(columns[0].mean, 4);
    EXPECT_EQ(columns[1].column, 1);
    EXPECT_DOUBLE_EQ(columns[1].mean, 5);
}

TEST(GatherColumns, PutsTheLastPointIntoTheLastColumn) {
    const std::vector<PlotPoint> points{{0, 1}, {1, 2}};
    const std::vector<PlotColumn> columns = gatherColumns(points, {0, 1}, 100);
    ASSERT_EQ(columns.size(), 2U);
    EXPECT_EQ(columns.back().column, 99);
}

TEST(GatherColumns, LosesNoPeakHoweverManyPoints) {
    std::vector<PlotPoint> points;
    for (int i = 0; i < 100000; ++i) {
        points.push_back({i * 1e-3, i == 54321 ? 1000.0 : 1.0});
    }
    double highest = 0;
    for (const PlotColumn& column : gatherColumns(points, {0, 100}, 250)) {
        highest = std::max(highest, column.high);
    }
    EXPECT_DOUBLE_EQ(highest, 1000);
}

TEST(GatherColumns, LeavesOutWhatIsOutsideOrNotFinite) {
    const std::vector<PlotPoint> points{{-1, 1}, {0.5, std::nan("")}, {2, 1}};
    EXPECT_TRUE(gatherColumns(points, {0, 1}, 10).empty());
}

}  // namespace
}  // namespace kerf::ui

#include "ui/plots/history.h"
#include "ui/plots/plot_math.h"

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
    const PlotRange range = paddedRange({10, 30}, 1);
    EXPECT_DOUBLE_EQ(range.low, 9);
    EXPECT_DOUBLE_EQ(range.high, 31);
}

TEST(PaddedRange, NeverShowsLessThanTheSmallestSpan) {
    EXPECT_EQ(paddedRange({100, 100}, 1), (PlotRange{99.5, 100.5}));
    EXPECT_EQ(paddedRange({1, -1}, 2), (PlotRange{0, 2})) << "turned over: there are no values";
}

Series seriesOf(const std::vector<PlotPoint>& points) {
    Series series;
    for (const PlotPoint& p : points) {
        series.add(p.x, p.y);
    }
    return series;
}

TEST(ValueRange, CoversTheBucketsInSightAndTheOneBefore) {
    const Series series = seriesOf({{0, 100}, {1, 7}, {2, 3}, {3, 50}});
    EXPECT_EQ(valueRange(bucketsIn(series.buckets(), {1.5, 2.5})), (PlotRange{3, 7}));
    EXPECT_EQ(valueRange(bucketsIn(series.buckets(), {-1, 9})), (PlotRange{3, 100}));
    EXPECT_TRUE(bucketsIn(series.buckets(), {4, 5}).empty());
    EXPECT_TRUE(bucketsIn({}, {0, 1}).empty());
}

TEST(NearestBucket, IsTheNearestOne) {
    const Series series = seriesOf({{0, 1}, {1, 2}, {3, 4}});
    EXPECT_EQ(nearestBucket(series.buckets(), -5).x, 0);
    EXPECT_EQ(nearestBucket(series.buckets(), 1.9).x, 1);
    EXPECT_EQ(nearestBucket(series.buckets(), 2.1).x, 3);
    EXPECT_EQ(nearestBucket(series.buckets(), 99).x, 3);
}

TEST(PlotView, ShowsAllUntilItIsZoomed) {
    EXPECT_EQ(rangeOf({}, 0.2), (PlotRange{0, 1})) << "an empty plot shows its first second";
    EXPECT_EQ(rangeOf({}, 7), (PlotRange{0, 7}));
    EXPECT_EQ(rangeOf({2, {}}, 7), (PlotRange{5, 7}));
    EXPECT_EQ(rangeOf({2, 4}, 7), (PlotRange{2, 4}));
}

TEST(PlotView, ZoomKeepsTheTimeUnderThePointer) {
    const PlotRange before = rangeOf({}, 10);
    const PlotView view = zoomed({}, 10, 3, 4, false);
    const PlotRange after = rangeOf(view, 10);
    EXPECT_LT(after.span(), before.span());
    EXPECT_NEAR((4 - after.low) / after.span(), 0.4, 1e-12);
    EXPECT_EQ(zoomed(view, 10, -9, 4, false), PlotView{}) << "far out it shows all again";
}

TEST(PlotView, ZoomFollowsWhileTimeRuns) {
    const PlotView view = zoomed({}, 10, 3, 4, true);
    EXPECT_FALSE(view.end.has_value());
    EXPECT_NEAR(rangeOf(view, 12).high, 12, 1e-12);
}

TEST(PlotView, PanStaysInsideTheRun) {
    const PlotView view{2, 5};
    EXPECT_EQ(rangeOf(panned(view, 10, 1), 10), (PlotRange{4, 6}));
    EXPECT_EQ(rangeOf(panned(view, 10, -99), 10), (PlotRange{0, 2}));
    const PlotView newest = panned(view, 10, 99);
    EXPECT_FALSE(newest.end.has_value()) << "at the newest value it follows";
    EXPECT_EQ(rangeOf(newest, 10), (PlotRange{8, 10}));
}

TEST(GatherColumns, KeepsTheExtremesOfEachColumn) {
    const Series series = seriesOf({{0.0, 1}, {0.1, 9}, {0.2, 2}, {0.9, 5}});
    const std::vector<PlotColumn> columns = gatherColumns(series.buckets(), {0, 1}, 2);
    ASSERT_EQ(columns.size(), 2U);
    EXPECT_EQ(columns[0].column, 0);
    EXPECT_DOUBLE_EQ(columns[0].low, 1);
    EXPECT_DOUBLE_EQ(columns[0].high, 9);
    EXPECT_DOUBLE_EQ(columns[0].mean, 4);
    EXPECT_EQ(columns[1].column, 1);
    EXPECT_DOUBLE_EQ(columns[1].mean, 5);
}

TEST(GatherColumns, PutsTheLastPointIntoTheLastColumn) {
    const Series series = seriesOf({{0, 1}, {1, 2}});
    const std::vector<PlotColumn> columns = gatherColumns(series.buckets(), {0, 1}, 100);
    ASSERT_EQ(columns.size(), 2U);
    EXPECT_EQ(columns.back().column, 99);
}

TEST(GatherColumns, LosesNoPeakHoweverManyPoints) {
    Series series;
    for (int i = 0; i < 100000; ++i) {
        series.add(i * 1e-3, i == 54321 ? 1000.0 : 1.0);
    }
    double highest = 0;
    for (const PlotColumn& column : gatherColumns(series.buckets(), {0, 100}, 250)) {
        highest = std::max(highest, column.high);
    }
    EXPECT_DOUBLE_EQ(highest, 1000);
}

TEST(GatherColumns, LeavesOutWhatIsOutside) {
    const Series series = seriesOf({{-1, 1}, {2, 1}});
    EXPECT_TRUE(gatherColumns(series.buckets(), {0, 1}, 10).empty());
}

TEST(PlotMath, NumbersStayShortAndTellSmallValues) {
    EXPECT_EQ(numberText(100.5, 2), "100.50");
    EXPECT_EQ(numberText(0, 9), "0");
    EXPECT_EQ(numberText(2e-15, 16), "2e-15");
    EXPECT_EQ(numberText(3.25e-9, 1), "3.25e-09") << "not 0.0";
    EXPECT_EQ(numberText(2.5e7, 0), "2.5e+07");
    EXPECT_EQ(numberText(99.999995, 6), "99.999995");
}

TEST(Series, KeepsEachValueWhileThereAreFew) {
    Series series;
    for (int i = 0; i < 1000; ++i) {
        series.add(i, 2 * i);
    }
    ASSERT_EQ(series.buckets().size(), 1000U);
    EXPECT_EQ(series.buckets()[7].x, 7);
    EXPECT_EQ(series.buckets()[7].low, 14);
    EXPECT_EQ(series.buckets()[7].high, 14);
    EXPECT_EQ(series.last(), 1998);
    EXPECT_EQ(series.mean(), 999);
    EXPECT_EQ(series.min(), 0);
    EXPECT_EQ(series.max(), 1998);
}

TEST(Series, StaysBoundedAndLosesNoExtreme) {
    const unsigned seed = 20261120;
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(-1, 1);
    Series series;
    double sum = 0;
    constexpr int kCount = 200000;
    for (int i = 0; i < kCount; ++i) {
        const double y = i == 77777 ? 50 : i == 123456 ? -60 : value(random);
        series.add(i * 1e-3, y);
        sum += y;
    }
    EXPECT_LE(series.buckets().size(), Series::kMostBuckets);
    EXPECT_GT(series.buckets().size(), Series::kMostBuckets / 4);
    int count = 0;
    double low = 0;
    double high = 0;
    double mean = 0;
    for (std::size_t i = 0; i < series.buckets().size(); ++i) {
        const SeriesBucket& bucket = series.buckets()[i];
        ASSERT_LE(bucket.low, bucket.mean);
        ASSERT_LE(bucket.mean, bucket.high);
        ASSERT_TRUE(i == 0 || bucket.x > series.buckets()[i - 1].x);
        low = std::min(low, bucket.low);
        high = std::max(high, bucket.high);
        count += bucket.count;
        mean += bucket.mean * bucket.count / kCount;
    }
    EXPECT_EQ(count, kCount);
    EXPECT_EQ(low, -60);
    EXPECT_EQ(high, 50);
    EXPECT_NEAR(mean, sum / kCount, 1e-9);
    EXPECT_NEAR(series.mean(), sum / kCount, 1e-9);
}

TEST(Series, ForgetsWhatCameLater) {
    Series series;
    for (int i = 0; i < 10; ++i) {
        series.add(i, i);
    }
    series.forgetAfter(4.5);
    EXPECT_EQ(series.buckets().size(), 5U);
    EXPECT_EQ(series.last(), 4);
    EXPECT_EQ(series.max(), 4);
    EXPECT_EQ(series.mean(), 2);
    series.forgetAfter(-1);
    EXPECT_TRUE(series.empty());
    EXPECT_EQ(series.last(), 0);
    EXPECT_EQ(series.mean(), 0);
}

TEST(Series, LeavesOutWhatIsNotFinite) {
    Series series;
    series.add(0, std::nan(""));
    series.add(1, HUGE_VAL);
    EXPECT_TRUE(series.empty());
    series.add(2, 5);
    EXPECT_EQ(series.buckets().size(), 1U);
}

bool isPlotted(Reading reading) {
    const auto shows = [reading](const PlotKind& plot) {
        return std::ranges::any_of(plot.curves, [reading](const CurveKind& curve) {
            return curve.label != nullptr && curve.reading == reading;
        });
    };
    return std::ranges::any_of(kPlots, shows) || std::ranges::any_of(kPointPlots, shows);
}

TEST(Plots, ShowEveryReadingButThatOfTheStatusBar) {
    for (int i = 0; i < static_cast<int>(Reading::count); ++i) {
        const auto reading = static_cast<Reading>(i);
        EXPECT_EQ(isPlotted(reading), reading != Reading::lostPieces) << "reading " << i;
    }
}

TEST(Plots, HaveNamesOfTheirOwn) {
    std::set<std::string> names;
    for (const PlotKind& plot : kPlots) {
        EXPECT_TRUE(names.insert(plot.id).second) << plot.id;
        for (const CurveKind& curve : plot.curves) {
            EXPECT_EQ(curve.label == nullptr, curve.reading == Reading::count) << plot.id;
        }
    }
}

TEST(Plots, TheDocsHaveTheirNames) {
    std::string row = "| `plots` | list of ";
    for (const PlotKind& plot : kPlots) {
        row.append(&plot == &kPlots.front() ? "`" : ", `").append(plot.id).append("`");
    }
    EXPECT_THAT(readBytes(KERF_SOURCE_DIR "/docs/editor.md"), HasSubstr(row + " |"));
}

}  // namespace
}  // namespace kerf::ui

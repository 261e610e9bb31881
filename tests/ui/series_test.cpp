#include <gtest/gtest.h>

#include <random>

#include "ui/plots/plot_math.h"

namespace kerf::ui {
namespace {

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

}  // namespace
}  // namespace kerf::ui

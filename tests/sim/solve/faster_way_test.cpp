#include <gtest/gtest.h>

#include <array>

#include "sim/solve/time_stepper.h"

namespace kerf {
namespace {

/// How often each way is taken in `steps`, where they take these times.
std::array<int, 2> taken(FasterWay& ways, const std::array<double, 2>& times, int steps) {
    std::array<int, 2> counts{};
    for (int step = 0; step < steps; ++step) {
        const std::size_t way = ways.next();
        ++counts[way];
        ways.took(times[way]);
    }
    return counts;
}

TEST(FasterWay, TriesBothAndStaysWithTheFaster) {
    FasterWay ways;
    EXPECT_EQ(taken(ways, {2.0, 1.0}, 30), (std::array{2, 28}));
    FasterWay others;
    EXPECT_EQ(taken(others, {1.0, 2.0}, 30), (std::array{28, 2}));
}

TEST(FasterWay, ForgetsTheFirstTimeOfEach) {
    FasterWay ways;
    for (const double time : {100.0, 1.0, 200.0, 2.0}) {
        ways.took(time);
    }
    EXPECT_EQ(taken(ways, {1.0, 2.0}, 30), (std::array{30, 0}));
}

TEST(FasterWay, LearnsThatTheOtherHasBecomeFaster) {
    FasterWay ways;
    taken(ways, {1.0, 2.0}, 30);
    const std::array<int, 2> counts = taken(ways, {1.0, 0.5}, 10 * FasterWay::kOtherAfter);
    EXPECT_GT(counts[1], 8 * FasterWay::kOtherAfter);
    EXPECT_GT(counts[0], 5);  // and looks again now and then
}

TEST(FasterWay, LeavesAWayAtOnceThatHasBecomeSlower) {
    FasterWay ways;
    taken(ways, {1.0, 2.0}, 10);
    EXPECT_EQ(taken(ways, {3.0, 2.0}, 10), (std::array{1, 9}));
}

}  // namespace
}  // namespace kerf

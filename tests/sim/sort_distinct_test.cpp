#include "sim/sort_distinct.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace kerf {
namespace {

// Dense numbers and such as lie far apart take turns.
TEST(DistinctSorter, SortsLikeAnyOther) {
    constexpr unsigned kSeed = 11;
    SCOPED_TRACE("seed " + std::to_string(kSeed));
    std::mt19937 random{kSeed};
    DistinctSorter sorter;
    for (const int count : {0, 1, 2, 63, 64, 65, 1000}) {
        for (const int gap : {1, 3, 100, 5000}) {
            std::vector<int> numbers(count);
            int next = static_cast<int>(random() % 1000);
            for (int& number : numbers) {
                number = next;
                next += 1 + static_cast<int>(random() % gap);
            }
            const std::vector<int> sorted = numbers;
            std::ranges::shuffle(numbers, random);
            sorter.sort(numbers);
            EXPECT_EQ(numbers, sorted) << count << " numbers up to " << gap << " apart";
        }
    }
}

}  // namespace
}  // namespace kerf
